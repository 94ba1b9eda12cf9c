// How strands go to the side of their lean curve: by the tile's offsets, and by paint and tufts as
// renderer/shaders/paint_form.glsl and tufts.glsl draw them.
#pragma once

#include <glm/glm.hpp>
#include <span>

#include "renderer/coat/clump.h"
#include "renderer/strands/root_fields.h"
#include "renderer/strands/tile_strands.h"

namespace pelage {

class StrandForm {
 public:
  /// Both must outlive it.
  StrandForm(const Coat& coat, const TileStrands& tile);

  /// Writes how far each knot of a strand lies beside the curve that it leans along, sizes. Shells look up, at a place
  /// x and a height s, the strand at x - m p / (1 - p), m being the way from x to the middle of its clump and p the
  /// part that has been gone; solved for x, with the tile's offset and painted curl o, middles m of root and parts p by
  /// clump and tuft: (o + sum of m p / (1 - p)) / (1 + sum of p / (1 - p)). A strand does not go to the side by more
  /// than it is long: offsets on the tile, made for longer fur, shrink to that.
  void sideways(std::uint32_t strand, const RootFields& root, std::span<glm::vec3> knots) const;

 private:
  struct Pull;
  Pull clump_pull(const Strand& strand, const RootFields& root) const;
  Pull tuft_pull(const RootFields& root) const;

  const Coat& coat_;
  const TileStrands& tile_;
  ClumpGrid clumps_;
};

}  // namespace pelage
