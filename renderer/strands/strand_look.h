// The form and the colours of strands: their offset from the lean curve by the tile, paint and tufts (as in
// renderer/shaders/paint_form.glsl and tufts.glsl), and the colour at each knot.
#pragma once

#include <array>
#include <cstdint>
#include <glm/glm.hpp>
#include <optional>
#include <span>

#include "renderer/coat/strand_tile.h"
#include "renderer/pattern/pattern.h"
#include "renderer/strands/grow_recipe.h"
#include "renderer/strands/root_fields.h"
#include "renderer/strands/tile_strands.h"

namespace pelage {

class StrandForm {
 public:
  /// Both arguments must outlive it.
  StrandForm(const Coat& coat, const TileStrands& tile);

  /// Writes the offset of each knot from the curve along which the strand leans, sizes.
  ///
  /// Shells look up, at a position x and a height s, the strand at x - m p / (1 - p), where m is the vector from x to
  /// the middle of its clump and p the part of it that the strand has moved. Solved for x, with the tile's offset and
  /// painted curl o, vectors m from the root, and parts p by clump and tuft, that is (o + sum of m p / (1 - p)) / (1 +
  /// sum of p / (1 - p)).
  ///
  /// A strand moves sideways by at most its length: offsets on the tile, made for longer fur, are scaled down to that.
  void sideways(std::uint32_t strand, const RootFields& root, std::span<glm::vec3> knots) const;

 private:
  struct Pull;
  Pull clump_pull(const Strand& strand, const RootFields& root) const;
  Pull tuft_pull(const RootFields& root) const;

  const Coat& coat_;
  const TileStrands& tile_;
  ClumpGrid clumps_;
};

// The colours of a strand at its position on the model: the tile's colours, changed by the model's own, the pattern,
// paint and water, as renderer/shells/fur/fur_fragment.glsl mixes them.

/// Samples a picture bilinearly and returns linear colour. `uv` has v up and wraps around. `linear` maps an sRGB byte
/// to linear.
glm::vec3 sample_picture(const ImageView& image, glm::vec2 uv, const std::array<float, 256>& linear);

class StrandColours {
 public:
  /// All arguments must outlive it.
  StrandColours(const FurModel& model, const GrowRecipe& recipe, const TileStrands& tile);

  /// Writes the linear colours of a strand's knots, packed by pack_colour. Returns the factor from the strand's colour
  /// to that of the mean strand (StrandSet::to_mean).
  std::uint32_t write(std::uint32_t strand, const RootFields& root, std::span<std::uint32_t> knots) const;
  /// Returns the linear colour of the mean strand at its root, which is also that of skin under fur.
  glm::vec3 under(const RootFields& root) const;

 private:
  struct Shared;  // values that all knots of a strand share
  Shared shared_at(const RootFields& root) const;
  glm::vec3 colour(const Shared& shared, const RootFields& root, glm::vec3 own, float s) const;
  glm::vec3 model_colour(const RootFields& root) const;
  float wet_exponent(float wetness) const;

  const FurModel& model_;
  const TileStrands& tile_;
  bool model_colours_;
  glm::vec3 ramp_root_;
  float own_wetness_;
  float over_largest_;  // 1 / the largest luminance of the ramp
  std::optional<PatternBlock> pattern_;
  std::array<float, 256> linear_;
};

}  // namespace pelage
