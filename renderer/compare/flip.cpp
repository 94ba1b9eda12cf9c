#include "renderer/compare/flip.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <numbers>

#include "base/parallel.h"
#include "renderer/compare/compare.h"

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

/// Returns the square root of the factor, because the product of two of these kernels is the filter in the plane.
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

namespace {

constexpr int strip_rows = 64;

/// An array of numbers, row by row.
struct Plane {
  Plane(int columns, int lines)
      : width(columns), height(lines), values(static_cast<std::size_t>(columns) * static_cast<std::size_t>(lines)) {}

  double* row(int y) { return values.data() + static_cast<std::ptrdiff_t>(y) * width; }
  const double* row(int y) const { return values.data() + static_cast<std::ptrdiff_t>(y) * width; }

  int width, height;
  std::vector<double> values;
};

/// sum += weight * from, for a row.
void add_scaled(double* sum, const double* from, double weight, int count) {
  for (int x = 0; x < count; ++x) sum[x] += weight * from[x];
}

/// Filters along the rows. `padded` has `reach` more columns on each side than the result.
Plane filter_across(const Plane& padded, const Kernel& kernel, int reach) {
  Plane filtered(padded.width - 2 * reach, padded.height);
  const int first = reach - radius_of(kernel);
  for (int y = 0; y < padded.height; ++y) {
    for (std::size_t k = 0; k < kernel.size(); ++k) {
      add_scaled(filtered.row(y), padded.row(y) + first + static_cast<int>(k), kernel[k], filtered.width);
    }
  }
  return filtered;
}

/// Filters along the columns and adds the result to `sum`; `padded` has `reach` more rows above and below.
void add_filtered_down(Plane& sum, const Plane& padded, const Kernel& kernel, int reach) {
  const int first = reach - radius_of(kernel);
  for (int y = 0; y < sum.height; ++y) {
    for (std::size_t k = 0; k < kernel.size(); ++k) {
      add_scaled(sum.row(y), padded.row(y + first + static_cast<int>(k)), kernel[k], sum.width);
    }
  }
}

Plane filter_down(const Plane& padded, const Kernel& kernel, int reach) {
  Plane filtered(padded.width, padded.height - 2 * reach);
  add_filtered_down(filtered, padded, kernel, reach);
  return filtered;
}

/// Rows [begin, end) of a picture with `reach` more on every side, in YCxCz.
struct Opponent {
  Plane y, cx, cz;
};

Opponent opponent_of(const FloatImage& picture, int begin, int end, int reach) {
  const int width = picture.width + 2 * reach, height = end - begin + 2 * reach;
  Opponent strip{{width, height}, {width, height}, {width, height}};
  for (int row = 0; row < height; ++row) {
    const int from = std::clamp(begin + row - reach, 0, picture.height - 1);
    for (int x = 0; x < picture.width; ++x) {
      const float* rgb = &picture.rgba[4 * (static_cast<std::size_t>(from) * static_cast<std::size_t>(picture.width) +
                                            static_cast<std::size_t>(x))];
      const glm::dvec3 colour = ycxcz_from_linear({rgb[0], rgb[1], rgb[2]});
      strip.y.row(row)[x + reach] = colour.x;
      strip.cx.row(row)[x + reach] = colour.y;
      strip.cz.row(row)[x + reach] = colour.z;
    }
    for (Plane* plane : {&strip.y, &strip.cx, &strip.cz}) {
      double* values = plane->row(row);
      std::fill(values, values + reach, values[reach]);
      std::fill(values + width - reach, values + width, values[width - reach - 1]);
    }
  }
  return strip;
}

/// A strip as perceived: colours after the filters of contrast sensitivity, and the strength of edges and points.
struct Seen {
  std::vector<glm::dvec3> lab;
  std::vector<double> edge, point;
};

void see_colour(Seen& seen, const Opponent& strip, const FlipKernels& kernels, int reach) {
  const Plane y = filter_down(filter_across(strip.y, kernels.luminance, reach), kernels.luminance, reach);
  const Plane cx = filter_down(filter_across(strip.cx, kernels.red_green, reach), kernels.red_green, reach);
  Plane cz(y.width, y.height);
  for (const Kernel* kernel : {&kernels.blue_yellow_narrow, &kernels.blue_yellow_wide}) {
    add_filtered_down(cz, filter_across(strip.cz, *kernel, reach), *kernel, reach);
  }
  seen.lab.resize(y.values.size());
  for (std::size_t i = 0; i < seen.lab.size(); ++i) {
    seen.lab[i] = hunt_lab_from_linear(linear_from_ycxcz({y.values[i], cx.values[i], cz.values[i]}));
  }
}

void see_features(Seen& seen, const Opponent& strip, const FlipKernels& kernels, int reach) {
  Plane grey = strip.y;
  for (double& value : grey.values) value = (value + 16) / 116;
  const Plane smooth = filter_across(grey, kernels.smooth, reach);
  const Plane edge_x = filter_down(filter_across(grey, kernels.edge, reach), kernels.smooth, reach);
  const Plane edge_y = filter_down(smooth, kernels.edge, reach);
  const Plane point_x = filter_down(filter_across(grey, kernels.point, reach), kernels.smooth, reach);
  const Plane point_y = filter_down(smooth, kernels.point, reach);
  for (std::size_t i = 0; i < edge_x.values.size(); ++i) {
    seen.edge.push_back(std::hypot(edge_x.values[i], edge_y.values[i]));
    seen.point.push_back(std::hypot(point_x.values[i], point_y.values[i]));
  }
}

Seen see(const FloatImage& picture, int begin, int end, const FlipKernels& kernels) {
  const int reach = kernels.reach();
  const Opponent strip = opponent_of(picture, begin, end, reach);
  Seen seen;
  see_colour(seen, strip, kernels, reach);
  see_features(seen, strip, kernels, reach);
  return seen;
}

constexpr double colour_exponent = 0.7;  // q_c of the paper

/// Returns the largest possible colour difference, between green and blue, raised to q_c.
double largest_colour_difference() {
  return std::pow(hyab(hunt_lab_from_linear({0, 1, 0}), hunt_lab_from_linear({0, 0, 1})), colour_exponent);
}

/// Raises a difference to q_c and maps it to [0, 1]: differences above p_c of the largest are compressed into the last
/// 1 - p_t (eq. 6).
double redistribute(double difference, double largest) {
  constexpr double p_c = 0.4, p_t = 0.95;
  const double raised = std::pow(difference, colour_exponent), knee = p_c * largest;
  if (raised < knee) return raised * p_t / knee;
  return p_t + (raised - knee) / (largest - knee) * (1 - p_t);
}

/// Writes the errors of a strip. Feature differences amplify colour differences: colour^(1 - feature) (eq. 8 and 9).
void write_errors(const Seen& reference, const Seen& test, float* errors) {
  const double largest = largest_colour_difference();
  for (std::size_t i = 0; i < reference.lab.size(); ++i) {
    const double edge = std::abs(reference.edge[i] - test.edge[i]),
                 point = std::abs(reference.point[i] - test.point[i]);
    const double feature = std::sqrt(std::max(edge, point) / std::sqrt(2.0));
    const double colour = redistribute(hyab(reference.lab[i], test.lab[i]), largest);
    errors[i] = static_cast<float>(std::clamp(std::pow(colour, 1 - feature), 0.0, 1.0));
  }
}

}  // namespace

std::vector<float> flip_map(const FloatImage& reference, const FloatImage& test, double pixels_per_degree,
                            int threads) {
  assert(reference.width == test.width && reference.height == test.height);
  assert(reference.width > 0 && reference.height > 0);
  const FlipKernels kernels = flip_kernels(pixels_per_degree);
  const std::size_t width = static_cast<std::size_t>(reference.width);
  const int strips = (reference.height + strip_rows - 1) / strip_rows;
  std::vector<float> errors(width * static_cast<std::size_t>(reference.height));
  const auto work = [&](std::uint32_t strip) {
    const int begin = static_cast<int>(strip) * strip_rows, end = std::min(begin + strip_rows, reference.height);
    const Seen first = see(reference, begin, end, kernels);
    write_errors(first, see(test, begin, end, kernels), errors.data() + width * static_cast<std::size_t>(begin));
  };
  for_each_in_parallel(static_cast<std::uint32_t>(strips), work, threads > 0 ? threads : default_threads());
  return errors;
}

}  // namespace pelage
