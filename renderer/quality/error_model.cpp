#include "renderer/quality/error_model.h"

#include <algorithm>
#include <cmath>

namespace pelage {

namespace {

double log_of(double pixels) { return std::log2(std::max(pixels, 1e-3)); }

}  // namespace

ErrorTraits error_traits_of(const ViewFeatures& view) {
  return {log_of(view.fur_pixels),
          log_of(view.strand_pixels),
          log_of(std::sqrt(std::max(view.covered, 1.0))),
          view.behind,
          std::log2(0.05 + view.bending),
          std::sqrt(view.lightness)};
}

ErrorTraits in_range(const Calibration& calibration, const ErrorTraits& traits) {
  ErrorTraits result{};
  for (std::size_t i = 0; i < error_traits; ++i) {
    const double range = calibration.high[i] - calibration.low[i];
    if (range > 0) result[i] = std::clamp((traits[i] - calibration.low[i]) / range, 0.0, 1.0);
  }
  return result;
}

double predicted_error(const CalibratedKnobs& row, const ErrorTraits& in_range) {
  double sum = row.log_error;
  for (std::size_t i = 0; i < error_traits; ++i) sum += row.slopes[i] * in_range[i];
  return std::clamp(std::exp(std::clamp(sum, -50.0, 50.0)), min_error, 1.0);
}

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
