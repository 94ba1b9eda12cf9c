// Which strands of a part are drawn.
#pragma once

#include "renderer/raster/kernels.h"

namespace pelage {

/// Whether a part may show in the box.
bool shows_in(const RasterScene& scene, const GrownPart& part, const PixelBox& box);

/// Pixels beside their places that strands may be drawn over, with so half a thickness from such a distance on, sizes:
/// thinned ones are wide, and hidden roots wider.
float drawn_beside(const RasterScene& scene, float thickest, float nearest);

/// Of so many of a part's strands one hands its light on to the others: of fewer where they are thick, each where they
/// are seen one by one.
std::uint32_t strands_of_lit(const RasterScene& scene, const GrownPart& part);
/// How many of a part's strands, from the first on, may hand their light on to the others up to `last`.
std::uint32_t lit_strands(const RasterScene& scene, const GrownPart& part, std::uint32_t last);

/// Share of a strand's colour that is its own, (0, 1]; the rest is that of the mean strand in its place. Of n strands
/// that it stands for the mean varies by 1 / sqrt(n) of what one does.
float own_colour(const RasterScene& scene, const GrownPart& part);

/// Which of a part's strands are drawn, and how wide.
struct StrandCull {
  std::uint32_t count = 0;  // the first so many, where they face the camera:
  double exact = 0;         // how many are wanted
  double whole = 1;         // how much wider each is
  glm::vec3 back{0};        // from the middle of the part's skin to the camera, unit
  float min_facing = 0;     // least cosine to it of a root's normal

  bool faces(const StrandRoot& root) const { return !(glm::dot(root.normal, back) < min_facing); }
  /// How much wider a strand is.
  float widened(std::uint32_t strand) const;
  bool thins = false;  // whether some are left out
};
StrandCull strand_cull(const RasterScene& scene, const GrownPart& part);

/// Its strands that are drawn: the first ones, as many as the quality wants, but for those that stand on the far side
/// of the body. Those that are left are wider by what they stand for, and the last eighth of them the narrower the
/// later they come, so that none appears at once when the camera comes nearer. Which they are depends on the skin, on
/// the part's longest strand and on how thick its first one is, beside what they are themselves.
void keep_strands(const RasterScene& scene, const GrownPart& part, KeptStrands& kept);

}  // namespace pelage
