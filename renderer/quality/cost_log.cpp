#include "renderer/quality/cost_log.h"

#include <algorithm>
#include <cmath>
#include <vector>

namespace pelage {

namespace {

double median(const std::deque<double>& numbers) {
  std::vector<double> ordered(numbers.begin(), numbers.end());
  const auto middle = ordered.begin() + static_cast<std::ptrdiff_t>(ordered.size() / 2);
  std::nth_element(ordered.begin(), middle, ordered.end());
  return *middle;
}

}  // namespace

CostCorrection CostLog::correction(std::uint64_t scene) const {
  const auto found = scenes_.find(scene);
  if (found == scenes_.end()) return {};
  return {found->second.correction, found->second.ratios.size() >= min_frames};
}

void CostLog::add(std::uint64_t scene, double predicted, double measured) {
  const double ratio = measured / predicted;
  if (!(ratio > 0) || !std::isfinite(ratio)) return;
  Scene& entry = scenes_[scene];
  entry.used = ++clock_;
  entry.ratios.push_back(ratio);
  if (entry.ratios.size() > window_frames) entry.ratios.pop_front();
  const double usual = std::clamp(median(entry.ratios), 1 / max, max), off = usual / entry.correction;
  if (entry.ratios.size() >= min_frames && (off > slack || off < 1 / slack))
    entry.correction = std::pow(step, std::round(std::log(usual) / std::log(step)));
  if (scenes_.size() <= max_scenes) return;
  scenes_.erase(std::min_element(scenes_.begin(), scenes_.end(),
                                 [](const auto& a, const auto& b) { return a.second.used < b.second.used; }));
}

}  // namespace pelage
