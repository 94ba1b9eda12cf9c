// Chooses which strands of a part are drawn and how wide, and which of them are lit.
#pragma once

#include "renderer/raster/kernels.h"

namespace pelage {

/// Returns whether a part may show in the box.
bool shows_in(const RasterScene& scene, const GrownPart& part, const PixelBox& box);

/// Returns how far, in pixels, strands may be drawn outside their exact positions. `thickest` is half the largest
/// thickness and `nearest` the smallest distance, both in sizes. Thinned strands are drawn wider, and hidden roots
/// wider still.
float drawn_beside(const RasterScene& scene, float thickest, float nearest);

/// Returns the size of the groups of a part's strands in which one strand is lit and shares its light with the others:
/// smaller where strands are thick, 1 where strands are seen one by one.
std::uint32_t strands_of_lit(const RasterScene& scene, const GrownPart& part);
/// Returns how many of a part's first strands are lit, to share their light with all up to the strand `last`.
std::uint32_t lit_strands(const RasterScene& scene, const GrownPart& part, std::uint32_t last);

/// Returns the share of a strand's colour that is its own, (0, 1]; the rest is that of the mean strand at its position.
/// The mean of the n strands that it stands for varies by 1 / sqrt(n) of what one strand does.
float own_colour(const RasterScene& scene, const GrownPart& part);

/// The rule by which a part's strands are drawn, and how wide.
struct StrandCull {
  std::uint32_t count = 0;  // only the first `count` strands are drawn: `exact`, rounded up
  double exact = 0;         // number of strands wanted, not rounded
  double width_factor = 1;  // factor on the width of strands that do not fade
  glm::vec3 to_camera{0};   // direction from the middle of the part's skin to the camera, unit
  float min_facing = 0;     // smallest cosine between a root's normal and `to_camera` of a strand that is drawn

  bool faces(const StrandRoot& root) const { return !(glm::dot(root.normal, to_camera) < min_facing); }
  /// Returns the factor on a strand's width.
  float widened(std::uint32_t strand) const;
  bool thins = false;  // some strands are left out
};
StrandCull strand_cull(const RasterScene& scene, const GrownPart& part);

/// Keeps the part's strands that are drawn: the first ones, as many as the quality asks for, without those on the far
/// side of the body. Kept strands are widened to stand for the others. In the last eighth of them, later strands are
/// narrower, so that no strand pops in when the camera comes nearer. The choice depends on the skin, on the part's
/// longest strand and on the thickness of its first one, as well as on the strands themselves.
void keep_strands(const RasterScene& scene, const GrownPart& part, KeptStrands& kept);

}  // namespace pelage
