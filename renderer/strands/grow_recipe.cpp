#include "renderer/strands/grow_recipe.h"

#include <algorithm>
#include <cmath>

#include "renderer/strands/tile_strands.h"

namespace pelage {

std::vector<GrowRecipe> recipes_of(const FurFrame& frame, bool has_colours, double area) {
  std::vector<GrowRecipe> recipes;
  for (const NamedCoat& one : frame.coats) {
    const double expected = expected_strands(area, one.coat);
    recipes.push_back({.coat = one.coat,
                       .model_colours = takes_model_colours(frame.look, has_colours),
                       .guard_share = expected > 0 ? std::min(one.coat.guard_hairs / expected, 1.0) : 0,
                       .extra_wetness = one.coat.wetness - frame.wetness()});
  }
  return recipes;
}

double expected_strands(const std::array<FurCorner, 3>& corners, const Coat& coat) {
  const auto [a, b, c] = tile_triangle(corners);
  const glm::dvec2 furthest = glm::max(glm::abs(a), glm::max(glm::abs(b), glm::abs(c)));
  if (!(furthest.x <= TileCells::furthest && furthest.y <= TileCells::furthest)) return 0;
  const double area = 0.5 * std::abs((b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x));
  const double weight = (corners[0].weight + corners[1].weight + corners[2].weight) / 3.0;
  return expected_strands(area * weight, coat);
}

double expected_strands(const FurModel& model, const Coat& coat) {
  double sum = 0;
  for (const auto& corners : model.corners) sum += expected_strands(corners, coat);
  return sum;
}

double fur_area(const FurModel& model) {
  Coat coat;
  coat.count = 1, coat.tile = 1;
  return expected_strands(model, coat);
}

}  // namespace pelage
