#include "renderer/quality/cost_model.h"

#include <algorithm>
#include <cmath>
#include <vector>

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

void CostLog::Record::add(double ratio) {
  ratios.push_back(ratio);
  if (ratios.size() > window_frames) ratios.pop_front();
  if (ratios.size() < min_frames) return;
  std::vector<double> ordered(ratios.begin(), ratios.end());
  const auto middle = ordered.begin() + static_cast<std::ptrdiff_t>(ordered.size() / 2);
  std::nth_element(ordered.begin(), middle, ordered.end());
  const double off = *middle / correction;
  if (off <= slack && off >= 1 / slack) return;
  const double bounded = std::clamp(*middle, 1 / max, max);
  correction = std::pow(step, std::round(std::log(bounded) / std::log(step)));
}

CostCorrection CostLog::correction(std::uint64_t scene) const {
  const auto found = scenes_.find(scene);
  if (found == scenes_.end()) return {};
  const Record &shells = found->second.shells, &sorted = found->second.sorted;
  return {shells.correction, sorted.correction, shells.learnt(), sorted.learnt()};
}

void CostLog::add(std::uint64_t scene, const Knobs& knobs, double predicted, double measured) {
  const double ratio = measured / predicted;
  if (!(ratio > 0) || !std::isfinite(ratio)) return;
  Scene& kept = scenes_[scene];
  kept.used = ++clock_;
  (knobs.order == FragmentOrder::sorted ? kept.sorted : kept.shells).add(ratio);
  if (scenes_.size() <= max_scenes) return;
  scenes_.erase(std::min_element(scenes_.begin(), scenes_.end(),
                                 [](const auto& a, const auto& b) { return a.second.used < b.second.used; }));
}

}  // namespace pelage
