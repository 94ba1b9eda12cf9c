#include "renderer/shading/fibre_paths.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

namespace pelage {

namespace {

using std::numbers::pi;

constexpr float largest_exponent = 80;  // beyond it exp(-x) is nothing in float

/// Differences of these are what narrow lobes fall by, so they are kept in double; scaled, for the direction has been
/// rounded.
struct Around {
  double sine = 0, cosine = 1, azimuth = 0;
};

Around around(glm::vec3 direction) {
  const glm::dvec3 d(direction);
  const double square = d.y * d.y + d.z * d.z, over_length = 1 / std::sqrt(d.x * d.x + square);
  return {d.x * over_length, std::sqrt(square) * over_length, std::atan2(d.z, d.y)};
}

/// A turn nearer to [-pi, pi], in which it is from within [-3 pi, 3 pi].
double wrapped(double angle) {
  if (angle > pi) return angle - 2 * pi;
  return angle < -pi ? angle + 2 * pi : angle;
}

}  // namespace

FibrePaths::FibrePaths(const FibreLobes& lobes, glm::vec3 view, float h, glm::vec3 sigma_a)
    : scale_(lobes.azimuthal_scale),
      over_scale_(static_cast<float>(1 / scale_)),
      logistic_normal_(static_cast<float>(1 / (scale_ * lobes.azimuthal_whole))) {
  const Around to_camera = around(view);
  for (int channel = 0; channel < 3; ++channel) {
    const LobeValues left = attenuation(to_camera.cosine, double(h), double(sigma_a[channel]), lobes.eta);
    for (std::size_t p = 0; p < lobe_count; ++p) lobes_[p].left[channel] = static_cast<float>(left[p]);
  }
  const double outside = std::asin(double(h)),
               inside = std::asin(refracted_offset(double(h), to_camera.cosine, lobes.eta));
  float sum = 0;
  for (std::size_t p = 0; p < lobe_count; ++p) {
    Lobe& lobe = lobes_[p];
    const double sine = lobes.tilt_sine[p], cosine = lobes.tilt_cosine[p];
    lobe.sine = to_camera.sine * cosine + to_camera.cosine * sine;
    lobe.cosine = std::abs(to_camera.cosine * cosine - to_camera.sine * sine);
    lobe.variance = lobes.variance[p];
    lobe.over_variance = static_cast<float>(1 / lobe.variance);
    lobe.normal = static_cast<float>(1 / lobes.whole[p]);
    if (p + 1 < lobe_count) {
      const double leaves = static_cast<double>(p) * (2 * inside + pi) - 2 * outside;  // exit_azimuth
      lobe.azimuth = wrapped(wrapped(to_camera.azimuth + leaves));
    }
    // The brightest channel absorbs least in every lobe, so by its share no channel's weight is above 1.
    sum += lobe.share = std::max({lobe.left.r, lobe.left.g, lobe.left.b});
  }
  for (Lobe& lobe : lobes_) lobe.share = sum > 0 ? lobe.share / sum : 0;
}

std::array<float, lobe_count> FibrePaths::shapes(glm::vec3 light) const {
  const Around from = around(light);
  std::array<float, lobe_count> values{};
  for (std::size_t p = 0; p < lobe_count; ++p) {
    const Lobe& lobe = lobes_[p];
    const double apart = from.cosine - lobe.cosine, sum = from.sine + lobe.sine;
    const float fall = static_cast<float>(apart * apart + sum * sum) * (lobe.over_variance / 2);
    if (fall > largest_exponent) continue;
    const float growth = scaled_bessel_i0(static_cast<float>(from.cosine * lobe.cosine) * lobe.over_variance);
    values[p] = growth * std::exp(-fall) * lobe.normal;
  }
  for (std::size_t p = 0; p + 1 < lobe_count; ++p) {
    if (!(values[p] > 0)) continue;
    const double off = std::abs(wrapped(from.azimuth - lobes_[p].azimuth));
    const float fall = std::exp(-std::min(static_cast<float>(off) * over_scale_, largest_exponent));
    values[p] *= logistic_normal_ * fall / ((1 + fall) * (1 + fall));
  }
  values[lobe_count - 1] *= static_cast<float>(1 / (2 * pi));
  return values;
}

glm::vec3 FibrePaths::value(glm::vec3 light) const {
  const std::array<float, lobe_count> shape = shapes(light);
  glm::vec3 sum(0);
  for (std::size_t p = 0; p < lobe_count; ++p) sum += shape[p] * lobes_[p].left;
  return sum;
}

float FibrePaths::pdf(glm::vec3 light) const {
  const std::array<float, lobe_count> shape = shapes(light);
  float sum = 0;
  for (std::size_t p = 0; p < lobe_count; ++p) sum += shape[p] * lobes_[p].share;
  return sum;
}

/// By the lobes' shares; one of none only where all have none.
std::size_t FibrePaths::choose(float u) const {
  std::size_t chosen = 0;
  for (std::size_t p = 0; p < lobe_count; ++p) {
    if (!(lobes_[p].share > 0)) continue;
    chosen = p;
    if (u < lobes_[p].share) break;
    u -= lobes_[p].share;
  }
  return chosen;
}

/// Mp is what a von Mises-Fisher lobe about the mirrored direction leaves along the strand, which is sampled exactly
/// (d'Eon 2011, 2013); Np by its inverse.
glm::vec3 FibrePaths::direction_of(std::size_t p, float u, glm::vec2 v) const {
  const Lobe& lobe = lobes_[p];
  const double rest = 1 - double(v.x);  // (0, 1]
  const double missing = std::min(-lobe.variance * std::log(rest + (1 - rest) * std::exp(-2 / lobe.variance)), 2.0);
  const double off = std::sqrt(std::max(missing * (2 - missing), 0.0)), turn = 2 * pi * double(v.y);
  const double up = off * std::cos(turn), aside = off * std::sin(turn);
  const double along = (missing - 1) * lobe.sine + up * lobe.cosine;
  const double across = std::hypot((1 - missing) * lobe.cosine + up * lobe.sine, aside);
  const double share = double(u) + 0x1p-25;  // (0, 1)
  const double azimuth = p + 1 == lobe_count ? 2 * pi * share : lobe.azimuth + sample_trimmed_logistic(share, scale_);
  return glm::vec3(along, across * std::cos(azimuth), across * std::sin(azimuth));
}

FibreSample FibrePaths::sample(glm::vec2 u, glm::vec2 v) const {
  const std::size_t p = choose(u.x);
  const Lobe& lobe = lobes_[p];
  if (!(lobe.share > 0)) return {};
  FibreSample sample{direction_of(p, u.y, v), lobe.left / lobe.share, 0};
  const std::array<float, lobe_count> shape = shapes(sample.direction);
  glm::vec3 value(0);
  for (std::size_t k = 0; k < lobe_count; ++k) {
    value += shape[k] * lobes_[k].left;
    sample.pdf += shape[k] * lobes_[k].share;
  }
  if (sample.pdf > 1e-30f) {
    sample.weight = value / sample.pdf;
  } else {  // the direction's rounding has left a narrow lobe: weigh it by itself
    sample.pdf = 1e-30f;
  }
  return sample;
}

}  // namespace pelage
