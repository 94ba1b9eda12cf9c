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

}  // namespace pelage
