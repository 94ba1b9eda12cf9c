// The texture that all cards of a groom share: locks of strands side by side.
#pragma once

#include "protocol/commands/coat.h"
#include "renderer/image/image.h"

namespace pelage {

/// Locks in a row, each for a quarter of the cards; roots are at the bottom.
inline constexpr int card_locks = 4;

/// How light the texture is where a strand is of the mean lightness, linear.
inline constexpr float card_lightness = 0.75f;

/// sRGB: how light strands are over their mean, in grey; alpha: what they cover. Strands are as thick as the coat's
/// against a card `width` sizes wide, become thinner towards their tips as they do, and their lengths differ.
Image card_texture(const Coat& coat, double width);

}  // namespace pelage
