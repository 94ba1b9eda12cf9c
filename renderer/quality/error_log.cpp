#include "renderer/quality/error_log.h"

#include <algorithm>
#include <cmath>

namespace pelage {

bool ErrorLog::Scene::is_like(const FurFrame& other, const ErrorTraits& others) const {
  for (std::size_t i = 0; i < traits.size(); ++i) {
    if (!(std::abs(traits[i] - others[i]) <= slack)) return false;
  }
  return frame.coat == other.coat && frame.look == other.look && frame.lights == other.lights &&
         frame.environment == other.environment && frame.exposure == other.exposure && frame.tone_map == other.tone_map;
}

MeasuredErrors& ErrorLog::of(const FurFrame& frame, const ErrorTraits& in_range) {
  if (scenes_.size() >= max_scenes && !scenes_.contains(frame.model)) {
    scenes_.erase(std::min_element(scenes_.begin(), scenes_.end(),
                                   [](const auto& a, const auto& b) { return a.second.used < b.second.used; }));
  }
  Scene& scene = scenes_[frame.model];
  if (scene.used == 0 || !scene.is_like(frame, in_range)) scene = {in_range, frame, {}, 0};
  scene.used = ++clock_;
  return scene.errors;
}

}  // namespace pelage
