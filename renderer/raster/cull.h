// Which strands of a part are drawn.
#pragma once

#include "renderer/raster/kernels.h"

namespace pelage {

/// Whether a part may show in the box.
bool shows_in(const RasterScene& scene, const GrownPart& part, const PixelBox& box);

/// Pixels beside their places that strands may be drawn over, with so half a thickness from such a distance on, sizes:
/// thinned ones are wide, and hidden roots wider.
float drawn_beside(const RasterScene& scene, float thickest, float nearest);

/// How many of a part's strands, from the first on, may hand their light on to the others up to `last`: fewer where
/// they are thin, all where each is seen by itself.
std::uint32_t lit_strands(const RasterScene& scene, const GrownPart& part, std::uint32_t last);

/// Share of a strand's colour that is its own, (0, 1]; the rest is that of the mean strand in its place. Of n strands
/// that it stands for the mean varies by 1 / sqrt(n) of what one does.
float own_colour(const RasterScene& scene, const GrownPart& part);

/// Its strands that are drawn: the first ones, as many as the quality wants, but for those that stand on the far side
/// of the body. Those that are left are wider by what they stand for, and the last eighth of them the narrower the
/// later they come, so that none appears at once when the camera comes nearer. Which they are depends on the skin, on
/// the part's longest strand and on how thick its first one is, beside what they are themselves.
void keep_strands(const RasterScene& scene, const GrownPart& part, KeptStrands& kept);

}  // namespace pelage
