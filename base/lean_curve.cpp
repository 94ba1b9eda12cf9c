#include "base/lean_curve.h"

#include <cassert>
#include <cmath>
#include <numbers>

namespace pelage {

namespace {

double sinc(double x) { return std::abs(x) < 1e-4 ? 1 - x * x / 6 : std::sin(x) / x; }

/// sqrt(1 + u^2) + asinh(u) / u: the arc length of a parabola over u, up to a constant factor; 2 at u = 0.
double parabola_length(double u) {
  return std::sqrt(1 + u * u) + (std::abs(u) < 1e-4 ? 1 - u * u / 6 : std::asinh(u) / u);
}

LeanPoint arc(double a0, double a, double s) {
  const double x = a * s;
  return {s * std::sin(a0 + x / 2) * sinc(x / 2), s * std::cos(a0 + x / 2) * sinc(x / 2), a0 + x};
}

/// Returns the point at arc length `s` of the parabola y = K sqrt(x), whose chord has the direction of the arc's chord,
/// rotated by the angle a0 at the root; u = 2y / K^2. Newton's method solves for the ratio r = u / u1, which stays
/// bounded when a goes to 0.
LeanPoint root(double a0, double a, double s) {
  const double u1 = 2 * std::tan(a / 2);
  const double total_length = parabola_length(u1);
  double r = s;
  for (int step = 0; step < 3; ++step) {
    const double u = r * u1;
    r -= (r * parabola_length(u) - s * total_length) / (2 * std::sqrt(1 + u * u));
  }
  const double y = 2 * r / total_length, x = r * r * u1 / total_length;
  return {y * std::sin(a0) + x * std::cos(a0), y * std::cos(a0) - x * std::sin(a0), a0 + std::atan(r * u1)};
}

}  // namespace

LeanPoint lean_point(LeanCurve curve, double inclination, double root_share, double s) {
  assert(inclination >= 0 && inclination <= 1 && root_share >= 0 && root_share <= 1 && s >= 0 && s <= 1);
  const double tip = inclination * std::numbers::pi / 2, a0 = root_share * tip;
  return curve == LeanCurve::arc ? arc(a0, tip - a0, s) : root(a0, tip - a0, s);
}

}  // namespace pelage
