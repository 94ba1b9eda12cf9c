#include "tests/double_shading/fibre_lobes.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <numbers>

namespace pelage {

namespace {

using std::numbers::pi;

double squared(double x) { return x * x; }

/// The difference of cosines keeps its digits in float too, where a product times an exponential would lose them.
template <typename Real>
Real longitudinal_of(Real cos_in, Real cos_out, Real sin_in, Real sin_out, Real v) {
  const Real apart = cos_in - cos_out, sum = sin_in + sin_out, whole = -v * std::expm1(-2 / v);
  return scaled_bessel_i0(cos_in * cos_out / v) * std::exp(-(apart * apart + sum * sum) / (2 * v)) / whole;
}

struct Between {
  int first = 0;
  double share = 0;  // weight of the next node, [0, 1]
};

Between between(double position, int count) {
  const double scaled = std::clamp(position, 0.0, 1.0) * (count - 1);
  const int first = std::min(static_cast<int>(scaled), count - 2);
  return {first, scaled - first};
}

}  // namespace

double scaled_bessel_i0(double x) {
  double sum = 1, term = 1;
  if (x < 30) {  // all terms are positive: no digits are lost
    for (int k = 1; term > 1e-17 * sum; ++k) sum += term *= squared(x / 2 / k);
    return sum * std::exp(-x);
  }
  for (int k = 1; k < 25; ++k) sum += term *= squared(2 * k - 1) / (8 * x * k);
  return sum / std::sqrt(2 * pi * x);
}

double longitudinal(double cos_in, double cos_out, double sin_in, double sin_out, double v) {
  return longitudinal_of(cos_in, cos_out, sin_in, sin_out, v);
}

float longitudinal(float cos_in, float cos_out, float sin_in, float sin_out, float v) {
  return longitudinal_of(cos_in, cos_out, sin_in, sin_out, v);
}

double trimmed_logistic(double x, double s) { return logistic(x, s) / logistic_share(s); }

LobeValues longitudinal_lobes(const FibreLobes& lobes, const Inclination& light, const Inclination& view) {
  LobeValues values{};
  for (std::size_t p = 0; p < lobe_count; ++p) {
    const double sine = lobes.tilt_sine[p], cosine = lobes.tilt_cosine[p];
    const double tilted_cosine = std::abs(view.cosine * cosine - view.sine * sine);
    values[p] = longitudinal(light.cosine, tilted_cosine, light.sine, view.sine * cosine + view.cosine * sine,
                             lobes.variance[p]);
  }
  return values;
}

LobeValues azimuthal_lobes(const FibreLobes& lobes, double cos_theta_view, double h, double azimuth) {
  LobeValues values{};
  for (int p = 0; p < lobe_count - 1; ++p) {
    const double apart = wrapped_angle(azimuth - exit_azimuth(p, h, cos_theta_view, lobes.eta));
    values[static_cast<std::size_t>(p)] = trimmed_logistic(apart, lobes.azimuthal_scale);
  }
  values[lobe_count - 1] = 1 / (2 * pi);
  return values;
}

double scatter_at_offset(const FibreLobes& lobes, const Inclination& light, const Inclination& view, double azimuth,
                         double h, double sigma_a) {
  const LobeValues m = longitudinal_lobes(lobes, light, view), n = azimuthal_lobes(lobes, view.cosine, h, azimuth);
  const LobeValues a = attenuation(view.cosine, h, sigma_a, lobes.eta);
  double sum = 0;
  for (std::size_t p = 0; p < lobe_count; ++p) sum += m[p] * a[p] * n[p];
  return sum;
}

LobeValues average_at(const AzimuthalAverage& average, double cos_theta, double azimuth, double sigma_a) {
  return average.sum(average.spread(average.exits(cos_theta), azimuth), average.passed(cos_theta, sigma_a), cos_theta,
                     azimuth);
}

LobeValues table_at(const ScatteringTable& table, double cos_theta, double azimuth, double absorption) {
  assert(!table.empty());
  const Between i = between(azimuth_coordinate(azimuth), table.azimuths);
  const Between j = between(cos_theta, table.inclinations), k = between(absorption, table.absorptions);
  LobeValues sum{};
  for (int corner = 0; corner < 8; ++corner) {
    const int di = corner & 1, dj = corner >> 1 & 1, dk = corner >> 2;
    const double weight = (di ? i.share : 1 - i.share) * (dj ? j.share : 1 - j.share) * (dk ? k.share : 1 - k.share);
    const int texel = ((k.first + dk) * table.inclinations + j.first + dj) * table.azimuths + i.first + di;
    for (std::size_t p = 0; p < lobe_count; ++p)
      sum[p] += weight * double(table.values[4 * static_cast<std::size_t>(texel) + p]);
  }
  return sum;
}

}  // namespace pelage
