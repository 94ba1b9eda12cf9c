#include "tests/double_shading/marschner_lobes.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace pelage {

namespace {

double inclination_angle(const Inclination& at) { return std::atan2(at.sine, at.cosine); }

/// A Gaussian of area 1.
double gaussian(double x, double deviation) {
  const double over = x / deviation;
  return std::exp(-over * over / 2) / (deviation * std::sqrt(2 * std::numbers::pi));
}

}  // namespace

double cos_difference(const Inclination& light, const Inclination& view) {
  return std::cos((inclination_angle(light) - inclination_angle(view)) / 2);
}

LobeValues marschner_longitudinal(const MarschnerLobes& lobes, const Inclination& light, const Inclination& view) {
  const double middle = (inclination_angle(light) + inclination_angle(view)) / 2;
  const double difference = cos_difference(light, view);
  LobeValues values{};
  for (std::size_t p = 0; p + 1 < lobe_count; ++p) {
    values[p] =
        gaussian(middle - lobes.centre[p], lobes.width[p]) / 2 / std::max(difference * difference, min_cos2_difference);
  }
  return values;
}

}  // namespace pelage
