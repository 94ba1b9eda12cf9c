#include "renderer/compare/flip_kernels.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <numbers>

namespace pelage {

namespace {

constexpr double pi = std::numbers::pi;
/// a sqrt(pi / b) exp(-pi^2 r^2 / b), r in degrees: the fit of the contrast sensitivity by Johnson and Fairchild.
constexpr double b_luminance = 0.0047, b_red_green = 0.0053;
constexpr double a_narrow = 34.1, b_narrow = 0.04, a_wide = 13.5, b_wide = 0.025;
constexpr double feature_width = 0.082;  // degrees

double sum_of(const Kernel& kernel) {
  double sum = 0;
  for (double weight : kernel) sum += weight;
  return sum;
}

void scale(Kernel& kernel, double factor) {
  for (double& weight : kernel) weight *= factor;
}

Kernel gaussian(double b, double factor, int radius, double pixels_per_degree) {
  Kernel kernel;
  for (int x = -radius; x <= radius; ++x) {
    const double degrees = x / pixels_per_degree;
    kernel.push_back(factor * std::exp(-pi * pi * degrees * degrees / b));
  }
  return kernel;
}

/// The square root, because the product of two of these is the filter in the plane.
double square_root_factor(double a, double b) { return std::sqrt(a * std::sqrt(pi / b)); }

void balance(Kernel& kernel) {
  double positive = 0, negative = 0;
  for (double weight : kernel) (weight > 0 ? positive : negative) += std::abs(weight);
  for (double& weight : kernel) weight /= weight > 0 ? positive : negative;
}

void add_contrast_sensitivity(FlipKernels& kernels, double ppd) {
  const int radius = static_cast<int>(std::ceil(3 * std::sqrt(b_narrow / (2 * pi * pi)) * ppd));
  kernels.luminance = gaussian(b_luminance, 1, radius, ppd);
  kernels.red_green = gaussian(b_red_green, 1, radius, ppd);
  scale(kernels.luminance, 1 / sum_of(kernels.luminance));
  scale(kernels.red_green, 1 / sum_of(kernels.red_green));
  Kernel& narrow = kernels.blue_yellow_narrow = gaussian(b_narrow, square_root_factor(a_narrow, b_narrow), radius, ppd);
  Kernel& wide = kernels.blue_yellow_wide = gaussian(b_wide, square_root_factor(a_wide, b_wide), radius, ppd);
  const double norm = 1 / std::hypot(sum_of(narrow), sum_of(wide));
  scale(narrow, norm);
  scale(wide, norm);
}

void add_features(FlipKernels& kernels, double ppd) {
  const double sigma = 0.5 * feature_width * ppd;
  const int radius = static_cast<int>(std::ceil(3 * sigma));
  for (int x = -radius; x <= radius; ++x) {
    const double g = std::exp(-x * x / (2 * sigma * sigma));
    kernels.smooth.push_back(g);
    kernels.edge.push_back(-x * g);
    kernels.point.push_back((x * x / (sigma * sigma) - 1) * g);
  }
  scale(kernels.smooth, 1 / sum_of(kernels.smooth));
  balance(kernels.edge);
  balance(kernels.point);
}

}  // namespace

int FlipKernels::reach() const { return std::max(radius_of(luminance), radius_of(smooth)); }

FlipKernels flip_kernels(double pixels_per_degree) {
  assert(pixels_per_degree >= 5 && pixels_per_degree <= 1000);
  FlipKernels kernels;
  add_contrast_sensitivity(kernels, pixels_per_degree);
  add_features(kernels, pixels_per_degree);
  return kernels;
}

}  // namespace pelage
