// The texture that all cards of a groom share: locks of strands side by side.
#pragma once

#include "protocol/commands/coat.h"
#include "renderer/image/image.h"

namespace pelage {

/// Number of locks in a row, each for a quarter of the cards; roots are at the bottom.
inline constexpr int card_locks = 4;

/// The linear value that a strand of the mean lightness has in the texture.
inline constexpr float card_lightness = 0.75f;

/// Draws the texture. sRGB: lightness of the strands relative to their mean, in grey; alpha: their coverage. Strands
/// have the coat's widths at root and tip, for a card that is `width` sizes wide, and different lengths.
Image card_texture(const Coat& coat, double width);

}  // namespace pelage
