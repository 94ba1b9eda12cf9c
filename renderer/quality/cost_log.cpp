#include "renderer/quality/cost_log.h"

#include <algorithm>
#include <cmath>
#include <vector>

namespace pelage {

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
