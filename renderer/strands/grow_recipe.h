// The settings for growing coats, and the number of strands to expect of them on the surface.
#pragma once

#include <array>
#include <glm/glm.hpp>
#include <vector>

#include "renderer/coat/strand_tile.h"
#include "renderer/input/fur_scene.h"

namespace pelage {

/// The settings for growing a coat, besides the model and its fields.
struct GrowRecipe {
  Coat coat;
  bool model_colours = false;  // hue from the model, lightness from the ramp (base_colour.glsl)
  double share = 1;            // share of the coat's strands to grow, chosen by a random number of each, (0, 1]
  double guard_share = 0;      // share of the strands that become guard hairs, [0, 1]
  double widening = 1;         // factor on strand width, >= 1: 1 / share preserves coverage
  double extra_wetness = 0;    // wetness beyond FurFrame::wetness, [0, 1]

  bool operator==(const GrowRecipe&) const = default;
};

/// Returns recipes to grow all strands of a frame's coats, at the widths that the coats have. `area` is the model's
/// fur_area.
std::vector<GrowRecipe> recipes_of(const FurFrame& frame, bool has_colours, double area);

// The number of strands to expect, before density, bare skin and GrowRecipe::share reduce it.

/// Returns a triangle of the model on the sample tile, in sizes.
inline std::array<glm::dvec2, 3> tile_triangle(const std::array<FurCorner, 3>& corners) {
  return {corners[0].tile_uv, corners[1].tile_uv, corners[2].tile_uv};
}

/// Returns the expected number of strands on a triangle; 0 where TileCells finds none.
double expected_strands(const std::array<FurCorner, 3>& corners, const Coat& coat);

/// Returns the expected number of strands on all triangles.
double expected_strands(const FurModel& model, const Coat& coat);

/// Returns the area of the fur on its sample tile, sizes^2: the expected number of strands at full density if one grows
/// per unit of area.
double fur_area(const FurModel& model);

}  // namespace pelage
