#include "renderer/quality/cost_model.h"

#include <algorithm>

namespace pelage {

namespace {

constexpr double million = 1e6, hundred_thousand = 1e5;
constexpr double min_cost = 1e-3;  // ms

}  // namespace

std::array<double, cost_terms> cost_terms_of(const ViewFeatures& view, const Knobs& knobs) {
  const double scale = knobs.scale, shells = knobs.shells, steps = knobs.steps;
  const double under = view.area * scale * scale / million;    // pixels under fur
  const double fragments = under * shells;                     // runs of the fur's shader
  const double sides = view.edges * scale * shells / million;  // blocks of pixels that triangles fill in part
  const double triangles = view.visible * shells / hundred_thousand;
  const double sorted = knobs.order == FragmentOrder::sorted ? 1 : 0;
  return {1,
          view.pixels / million,
          view.pixels * scale * scale / million,
          view.triangles / hundred_thousand,
          triangles,
          under * (1 + view.lights),
          fragments,
          fragments * steps,
          fragments * view.lights,
          sides,
          sides * steps,
          view.scatters ? (fragments + sides) * view.lights : 0,
          view.varies ? fragments + sides : 0,
          sorted * fragments,
          sorted * sides,
          sorted * triangles};
}

double predicted_cost(const Calibration& calibration, const ViewFeatures& view, const Knobs& knobs) {
  const std::array<double, cost_terms> terms = cost_terms_of(view, knobs);
  double sum = 0;
  for (std::size_t i = 0; i < cost_terms; ++i) sum += calibration.cost[i] * terms[i];
  return std::max(sum, min_cost);
}

}  // namespace pelage
