// The colours of a strand where it stands: the tile's through the model's own, the pattern, paint and water, as
// renderer/passes/fur/fur.frag mixes them.
#pragma once

#include <array>
#include <cstdint>
#include <glm/glm.hpp>
#include <optional>
#include <span>

#include "renderer/pattern/pattern.h"
#include "renderer/strands/grow.h"
#include "renderer/strands/root_fields.h"
#include "renderer/strands/tile_strands.h"

namespace pelage {

/// A picture between its texels, linear; `uv` with v up, repeated.
glm::vec3 sample_picture(const ImageView& image, glm::vec2 uv, const std::array<float, 256>& linear);

class StrandColours {
 public:
  /// All must outlive it.
  StrandColours(const FurModel& model, const GrowRecipe& recipe, const TileStrands& tile);

  /// Linear colours of a strand's knots, packed.
  void write(std::uint32_t strand, const RootFields& root, std::span<std::uint32_t> knots) const;

 private:
  glm::vec3 model_colour(const RootFields& root) const;
  float wet_exponent(float wetness) const;

  const FurModel& model_;
  const TileStrands& tile_;
  bool model_colours_;
  float own_wetness_;
  float over_largest_;  // 1 / the largest luminance of the ramp
  std::optional<PatternBlock> pattern_;
  std::array<float, 256> linear_;
};

}  // namespace pelage
