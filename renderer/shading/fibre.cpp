#include "renderer/shading/fibre.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <limits>
#include <numbers>

namespace pelage {

double fresnel_dielectric(double cos_incidence, double eta) {
  assert(eta >= 1);
  if (!(cos_incidence > 0)) return 1;
  const double squared = eta * eta - 1 + cos_incidence * cos_incidence;  // (eta cos of the refracted angle)^2
  const double inside = std::sqrt(squared) / eta;
  const double parallel = (eta * cos_incidence - inside) / (eta * cos_incidence + inside);
  const double across = (cos_incidence - eta * inside) / (cos_incidence + eta * inside);
  return (parallel * parallel + across * across) / 2;
}

namespace {

struct Legendre {
  double value = 0;
  double slope = 0;
};

/// P_n(x) and its derivative for |x| < 1, by the three-term recurrence.
Legendre legendre(int n, double x) {
  double before = 0, value = 1;
  for (int k = 1; k <= n; ++k) {
    const double next = ((2 * k - 1) * x * value - (k - 1) * before) / k;
    before = value;
    value = next;
  }
  return {value, n * (x * value - before) / (x * x - 1)};
}

}  // namespace

std::vector<QuadratureNode> gauss_legendre(int count, double from, double to) {
  assert(count >= 1);
  const double middle = (from + to) / 2, half = (to - from) / 2;
  std::vector<QuadratureNode> nodes;
  nodes.reserve(static_cast<std::size_t>(count));
  for (int i = count - 1; i >= 0; --i) {
    double x = std::cos(std::numbers::pi * (i + 0.75) / (count + 0.5));  // near the root; Newton does the rest
    for (int step = 0; step < 4; ++step) {
      const Legendre p = legendre(count, x);
      x -= p.value / p.slope;
    }
    const double slope = legendre(count, x).slope;
    nodes.push_back({middle + half * x, half * 2 / ((1 - x * x) * slope * slope)});
  }
  return nodes;
}

namespace {

using std::numbers::pi;

double square(double x) { return x * x; }

}  // namespace

double longitudinal_variance(double beta_m) {
  return std::max(4e-7, square(0.726 * beta_m + 0.812 * beta_m * beta_m + 3.7 * std::pow(beta_m, 20)));
}

double azimuthal_scale(double beta_n) {
  const double scale = 0.265 * beta_n + 1.194 * beta_n * beta_n + 5.372 * std::pow(beta_n, 22);
  return std::max(1e-4, std::sqrt(pi / 8) * scale);
}

float scaled_bessel_i0(float x) {  // Abramowitz and Stegun 9.8.1 and 9.8.2; error 2e-7
  const float t = x / 3.75f;
  if (t < 1) {
    const float u = t * t;
    const float sum =
        1 +
        u * (3.5156229f + u * (3.0899424f + u * (1.2067492f + u * (0.2659732f + u * (0.0360768f + u * 0.0045813f)))));
    return sum * std::exp(-x);
  }
  const float u = 1 / t;
  const float head = 0.39894228f + u * (0.01328592f + u * (0.00225319f - u * 0.00157565f));
  const float tail = 0.00916281f + u * (-0.02057706f + u * (0.02635537f + u * (-0.01647633f + u * 0.00392377f)));
  return (head + u * u * u * u * tail) / std::sqrt(x);
}

double wrapped_angle(double angle) { return angle - 2 * pi * std::nearbyint(angle / (2 * pi)); }

double logistic(double x, double s) {
  const double fall = std::exp(-std::abs(x) / s);
  return fall / (s * square(1 + fall));
}

double logistic_share(double s) { return std::tanh(pi / (2 * s)); }

double sample_trimmed_logistic(double u, double s) {
  const double beyond = 1 / (1 + std::exp(pi / s)), below = beyond + u * logistic_share(s);
  return std::clamp(s * std::log(below / (1 - below)), -pi, pi);
}

double colour_polynomial(double beta_n) {
  return 5.969 + beta_n * (-0.215 + beta_n * (2.532 + beta_n * (-10.73 + beta_n * (5.574 + beta_n * 0.245))));
}

glm::dvec3 absorption_from_colour(const glm::dvec3& colour, double beta_n) {
  const glm::dvec3 root = glm::log(glm::clamp(colour, 1e-6, 1.0)) / colour_polynomial(beta_n);
  return root * root;
}

glm::dvec3 absorption_from_melanin(double eumelanin, double pheomelanin) {
  return eumelanin * glm::dvec3(0.419, 0.697, 1.37) + pheomelanin * glm::dvec3(0.187, 0.4, 1.05);
}

double refracted_offset(double h, double cos_theta, double eta) {
  const double along = std::sqrt(eta * eta - 1 + cos_theta * cos_theta);
  return along > 0 ? std::clamp(h * cos_theta / along, -1.0, 1.0) : h;
}

double exit_azimuth(int internal, double h, double cos_theta, double eta) {
  return 2 * internal * std::asin(refracted_offset(h, cos_theta, eta)) - 2 * std::asin(h) + internal * pi;
}

LobeValues attenuation(double cos_theta, double h, double sigma_a, double eta) {
  assert(eta >= 1 && sigma_a >= 0 && std::abs(h) <= 1);
  const double reflected = fresnel_dielectric(cos_theta * std::sqrt(1 - h * h), eta);
  const double cos_gamma = std::sqrt(1 - square(refracted_offset(h, cos_theta, eta)));
  const double cos_inside = std::sqrt(eta * eta - 1 + cos_theta * cos_theta) / eta;
  const double passed = std::exp(-sigma_a * 2 * cos_gamma / std::max(cos_inside, 1e-9));
  const double once = square(1 - reflected) * passed, bounce = passed * reflected;
  const double rest = bounce < 1 ? once * bounce * bounce / (1 - bounce) : 0;
  return {reflected, once, once * bounce, rest};
}

FibreLobes energy_conserving_lobes(const FibreOptics& fibre) {
  const double v = longitudinal_variance(fibre.longitudinal_roughness);
  const double alpha = fibre.cuticle_tilt * pi / 180;
  FibreLobes lobes{{v, v / 4, 4 * v, 4 * v},
                   {-2 * alpha, alpha, 4 * alpha, 0},
                   azimuthal_scale(fibre.azimuthal_roughness),
                   fibre.refractive_index};
  lobes.azimuthal_normalisation = std::tanh(pi / (2 * lobes.azimuthal_scale));
  for (std::size_t p = 0; p < lobe_count; ++p) {
    lobes.tilt_sine[p] = std::sin(lobes.tilt[p]), lobes.tilt_cosine[p] = std::cos(lobes.tilt[p]);
    lobes.longitudinal_normalisation[p] = -lobes.variance[p] * std::expm1(-2 / lobes.variance[p]);
  }
  return lobes;
}

namespace {

using std::numbers::pi;

constexpr float largest_exponent = 80;  // beyond it exp(-x) is negligible in float

/// A direction about the fibre's axis. Narrow lobes fall off by small differences of these values, so they are double,
/// and normalized, because the direction was rounded to float.
struct Around {
  double sine = 0, cosine = 1, azimuth = 0;
};

Around around(glm::vec3 direction) {
  const glm::dvec3 d(direction);
  const double square = d.y * d.y + d.z * d.z, over_length = 1 / std::sqrt(d.x * d.x + square);
  return {d.x * over_length, std::sqrt(square) * over_length, std::atan2(d.z, d.y)};
}

/// Moves an angle by up to one turn towards [-pi, pi]; angles within [-3 pi, 3 pi] end up inside of it.
double wrapped(double angle) {
  if (angle > pi) return angle - 2 * pi;
  return angle < -pi ? angle + 2 * pi : angle;
}

}  // namespace

FibrePaths::FibrePaths(const FibreLobes& lobes, glm::vec3 view, float h, glm::vec3 sigma_a)
    : scale_(lobes.azimuthal_scale),
      over_scale_(static_cast<float>(1 / scale_)),
      logistic_normal_(static_cast<float>(1 / (scale_ * lobes.azimuthal_normalisation))) {
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
    lobe.normal = static_cast<float>(1 / lobes.longitudinal_normalisation[p]);
    if (p + 1 < lobe_count) {
      const double leaves = static_cast<double>(p) * (2 * inside + pi) - 2 * outside;  // exit_azimuth
      lobe.azimuth = wrapped(wrapped(to_camera.azimuth + leaves));
    }
    // The brightest channel absorbs least in every lobe; with its shares as probabilities no channel's weight is above
    // 1.
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

/// Chooses a path by the lobes' shares. It chooses a lobe with share 0 only if all shares are 0.
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

/// Samples Mp exactly, as the marginal along the strand of a von Mises-Fisher lobe about the mirrored direction (d'Eon
/// 2011, 2013), and Np by its inverse CDF.
glm::vec3 FibrePaths::direction_of(std::size_t p, float u, glm::vec2 v) const {
  const Lobe& lobe = lobes_[p];
  const double rest = 1 - double(v.x);  // (0, 1]
  const double missing = std::min(-lobe.variance * std::log(rest + (1 - rest) * std::exp(-2 / lobe.variance)), 2.0);
  const double off = std::sqrt(std::max(missing * (2 - missing), 0.0)), angle = 2 * pi * double(v.y);
  const double up = off * std::cos(angle), aside = off * std::sin(angle);
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
  } else {  // rounding moved the direction out of a narrow lobe: use that lobe's weight alone
    sample.pdf = 1e-30f;
  }
  return sample;
}

}  // namespace pelage
