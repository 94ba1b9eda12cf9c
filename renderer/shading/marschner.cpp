#include "renderer/shading/marschner.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "renderer/shading/fresnel.h"

namespace pelage {

namespace {

using std::numbers::pi;

double inclination_angle(const Inclination& inclination) { return std::atan2(inclination.sine, inclination.cosine); }

double gaussian(double x, double width) { return std::exp(-x * x / (2 * width * width)) / (width * std::sqrt(2 * pi)); }

}  // namespace

MarschnerLobes marschner_lobes(const FibreOptics& fibre) {
  const double alpha = fibre.cuticle_tilt * pi / 180, beta = fibre.highlight_width * pi / 180;
  const auto width = [](double wanted) { return std::max(wanted, 1e-3); };
  return {{alpha, -alpha / 2, -1.5 * alpha, 0},
          {width(beta), width(beta / 2), width(2 * beta), 1},
          fibre.caustic_width * pi / 180,
          fibre.refractive_index};
}

double cos_difference(const Inclination& light, const Inclination& eye) {
  return std::cos((inclination_angle(light) - inclination_angle(eye)) / 2);
}

LobeValues marschner_longitudinal(const MarschnerLobes& lobes, const Inclination& light, const Inclination& eye) {
  const double middle = (inclination_angle(light) + inclination_angle(eye)) / 2;
  const double difference = cos_difference(light, eye);
  LobeValues values{};
  for (std::size_t p = 0; p + 1 < lobe_count; ++p) {
    values[p] = gaussian(middle - lobes.centre[p], lobes.width[p]) / 2 /
                std::max(difference * difference, least_cos2_difference);
  }
  return values;
}

double marschner_reflection(double cos_theta_d, double azimuth, double eta) {
  const double cos_gamma = std::max(0.0, std::cos(azimuth / 2));
  return cos_gamma / 4 * fresnel_dielectric(cos_theta_d * cos_gamma, eta);
}

double caustic_spread(double apart, double width) {
  return gaussian(apart, width) / std::erf(pi / (width * std::sqrt(2.0)));
}

}  // namespace pelage
