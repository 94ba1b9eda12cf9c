#include "renderer/compare/compare.h"

#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>
#include <functional>
#include <string>

#include "base/colour_space.h"
#include "renderer/compare/flip.h"

namespace pelage {

namespace {

/// Returns the matrix from linear RGB to XYZ relative to white: each row sums to 1. GLM stores columns.
glm::dmat3 white_relative() {
  const glm::dmat3 rows(glm::dvec3(10135552, 8788810, 4435075) / 24577794.0,
                        glm::dvec3(2613072, 8788810, 887015) / 12288897.0,
                        glm::dvec3(1425312, 8788810, 70074185) / 73733382.0);
  glm::dmat3 scaled;
  for (int k = 0; k < 3; ++k) scaled[k] = rows[k] / (rows[k].x + rows[k].y + rows[k].z);
  return glm::transpose(scaled);
}

double lab_curve(double t) {
  constexpr double delta = 6.0 / 29;
  return t > delta * delta * delta ? std::cbrt(t) : t / (3 * delta * delta) + 4.0 / 29;
}

}  // namespace

glm::dvec3 ycxcz_from_linear(const glm::dvec3& linear) {
  static const glm::dmat3 matrix = white_relative();
  const glm::dvec3 xyz = matrix * linear;
  return {116 * xyz.y - 16, 500 * (xyz.x - xyz.y), 200 * (xyz.y - xyz.z)};
}

glm::dvec3 linear_from_ycxcz(const glm::dvec3& ycxcz) {
  static const glm::dmat3 inverse = glm::inverse(white_relative());
  const double y = (ycxcz.x + 16) / 116;
  return glm::clamp(inverse * glm::dvec3(y + ycxcz.y / 500, y, y - ycxcz.z / 200), 0.0, 1.0);
}

glm::dvec3 hunt_lab_from_linear(const glm::dvec3& linear) {
  static const glm::dmat3 matrix = white_relative();
  const glm::dvec3 xyz = matrix * linear;
  const double x = lab_curve(xyz.x), y = lab_curve(xyz.y), z = lab_curve(xyz.z);
  const double lightness = 116 * y - 16;
  return {lightness, 0.01 * lightness * 500 * (x - y), 0.01 * lightness * 200 * (y - z)};
}

double hyab(const glm::dvec3& first, const glm::dvec3& second) {
  const glm::dvec3 d = first - second;
  return std::abs(d.x) + std::sqrt(d.y * d.y + d.z * d.z);
}

namespace {

template <class Inside>
Mask mask_of(const FloatImage& image, Inside inside) {
  Mask mask{image.width, image.height, std::vector<std::uint8_t>(image.rgba.size() / 4)};
  for (std::size_t i = 0; i < mask.inside.size(); ++i) mask.inside[i] = inside(&image.rgba[i * 4]) ? 1 : 0;
  return mask;
}

/// Returns for each pixel the distance along its row to the nearest pixel of this side, at most `far`.
std::vector<int> row_distances(const Mask& mask, std::uint8_t side, int far) {
  std::vector<int> distances(mask.inside.size());
  const std::size_t width = static_cast<std::size_t>(mask.width);
  for (std::size_t begin = 0; begin < distances.size(); begin += width) {
    int distance = far;
    for (std::size_t i = begin; i < begin + width; ++i) {
      distance = mask.inside[i] == side ? 0 : std::min(distance + 1, far);
      distances[i] = distance;
    }
    distance = far;
    for (std::size_t i = begin + width; i-- > begin;) {
      distance = mask.inside[i] == side ? 0 : std::min(distance + 1, far);
      distances[i] = std::min(distances[i], distance);
    }
  }
  return distances;
}

}  // namespace

std::size_t Mask::count() const { return static_cast<std::size_t>(std::count(inside.begin(), inside.end(), 1)); }

Mask alpha_mask(const FloatImage& image) {
  constexpr float min = 0.999f / 255;  // includes a rounded 1/255
  return mask_of(image, [](const float* rgba) { return rgba[3] >= min; });
}

Mask luminance_mask(const FloatImage& image) {
  const double half = linear_from_srgb(0.5);
  return mask_of(image, [half](const float* rgba) { return luminance(glm::dvec3(rgba[0], rgba[1], rgba[2])) > half; });
}

Mask union_of(const Mask& first, const Mask& second) {
  assert(first.width == second.width && first.height == second.height);
  Mask both = first;
  std::transform(first.inside.begin(), first.inside.end(), second.inside.begin(), both.inside.begin(),
                 std::bit_or<std::uint8_t>());
  return both;
}

Mask silhouette_band(const Mask& mask, double pixels) {
  assert(pixels >= 0 && pixels <= 1000);
  const int reach = static_cast<int>(pixels), far = reach + 1;
  const std::vector<int> to_outside = row_distances(mask, 0, far), to_inside = row_distances(mask, 1, far);
  Mask band{mask.width, mask.height, std::vector<std::uint8_t>(mask.inside.size())};
  const auto index = [&](int x, int y) {
    return static_cast<std::size_t>(y) * static_cast<std::size_t>(mask.width) + static_cast<std::size_t>(x);
  };
  for (int y = 0; y < mask.height; ++y) {
    for (int row = std::max(0, y - reach); row <= std::min(mask.height - 1, y + reach); ++row) {
      const double farthest = std::sqrt(pixels * pixels - (row - y) * (row - y));
      for (int x = 0; x < mask.width; ++x) {
        const std::vector<int>& distances = mask.inside[index(x, y)] ? to_outside : to_inside;
        if (distances[index(x, row)] <= farthest) band.inside[index(x, y)] = 1;
      }
    }
  }
  return band;
}

namespace {

/// sRGB at steps of a tenth: a least-squares fit of line segments to magma.
constexpr std::array<std::array<double, 3>, 11> ramp = {{{0.000, 0.000, 0.004},
                                                         {0.073, 0.061, 0.215},
                                                         {0.231, 0.059, 0.450},
                                                         {0.395, 0.098, 0.508},
                                                         {0.549, 0.163, 0.507},
                                                         {0.713, 0.212, 0.481},
                                                         {0.874, 0.281, 0.408},
                                                         {0.973, 0.432, 0.349},
                                                         {0.997, 0.626, 0.421},
                                                         {0.997, 0.809, 0.567},
                                                         {0.987, 0.992, 0.748}}};

}  // namespace

Image error_picture(const std::vector<float>& errors, int width, int height) {
  assert(errors.size() == static_cast<std::size_t>(width) * static_cast<std::size_t>(height));
  Image picture{width, height, {}};
  picture.rgba.reserve(errors.size() * 4);
  for (float error : errors) {
    const double position = (std::isnan(error) ? 1.0 : std::clamp(static_cast<double>(error), 0.0, 1.0)) * 10;
    const std::size_t below = std::min<std::size_t>(static_cast<std::size_t>(position), 9);
    const double share = position - static_cast<double>(below);
    for (std::size_t k = 0; k < 3; ++k) {
      const double value = ramp[below][k] + share * (ramp[below + 1][k] - ramp[below][k]);
      picture.rgba.push_back(static_cast<std::uint8_t>(std::lround(value * 255)));
    }
    picture.rgba.push_back(255);
  }
  return picture;
}

namespace {

std::string size_of(int width, int height) { return std::to_string(width) + " x " + std::to_string(height); }

bool is_within(double value, double low, double high) { return value >= low && value <= high; }

Status check(const FloatImage& reference, const FloatImage& test, const Mask& mask, const CompareOptions& options) {
  if (reference.width != test.width || reference.height != test.height) {
    return failure(Code::invalid, "The pictures differ in size: " + size_of(reference.width, reference.height) +
                                      " and " + size_of(test.width, test.height) + " pixels.");
  }
  if (mask.width != reference.width || mask.height != reference.height) {
    return failure(Code::invalid, "The mask has another size than the pictures: " + size_of(mask.width, mask.height) +
                                      " and " + size_of(reference.width, reference.height) + " pixels.");
  }
  if (mask.count() == 0) return failure(Code::invalid, "The mask is empty: there is nothing to compare.");
  if (!is_within(options.pixels_per_degree, 5, 1000)) {
    return failure(Code::invalid, "Pixels per degree are out of range.", "/pixels_per_degree", "[5, 1000]");
  }
  if (!is_within(options.background, 0, 1)) {
    return failure(Code::invalid, "The background is out of range.", "/background", "[0, 1]");
  }
  if (!is_within(options.silhouette, 0, 1000)) {
    return failure(Code::invalid, "The width of the silhouette is out of range.", "/silhouette", "[0, 1000]");
  }
  return {};
}

std::size_t count_non_finite(const FloatImage& reference, const FloatImage& test) {
  const auto is_finite = [](const FloatImage& image, std::size_t i) {
    return std::all_of(&image.rgba[i], &image.rgba[i] + 4, [](float value) { return std::isfinite(value); });
  };
  std::size_t count = 0;
  for (std::size_t i = 0; i < reference.rgba.size(); i += 4) {
    if (!is_finite(reference, i) || !is_finite(test, i)) ++count;
  }
  return count;
}

/// The filmic curve of renderer/finish/encode.cpp.
double film(double x) {
  x = std::min(x, 1e4) * 0.72;
  return x * (2.51 * x + 0.03) / (x * (2.43 * x + 0.59) + 0.14);
}

double display_value(double value, ToneMap tone_map) {
  const double positive = std::max(value, 0.0);
  return std::clamp(tone_map == ToneMap::filmic ? film(positive) : positive, 0.0, 1.0);
}

glm::dvec3 over_background(const FloatImage& image, std::size_t pixel, double background) {
  const float* rgba = &image.rgba[pixel * 4];
  const double rest = background * (1 - std::clamp(static_cast<double>(rgba[3]), 0.0, 1.0));
  return glm::dvec3(rgba[0], rgba[1], rgba[2]) + rest;
}

void measure_light(PictureFigures& figures, const FloatImage& reference, const FloatImage& test, const Mask& mask,
                   double background) {
  constexpr double epsilon = 0.01;
  double count = 0, relative = 0, square = 0, bias = 0, bright = 0;
  for (std::size_t i = 0; i < mask.inside.size(); ++i) {
    if (!mask.inside[i]) continue;
    const glm::dvec3 truth = over_background(reference, i, background);
    const glm::dvec3 difference = over_background(test, i, background) - truth;
    const glm::dvec3 squares = difference * difference, shares = squares / (truth * truth + epsilon);
    count += 1;
    square += squares.x + squares.y + squares.z;
    relative += shares.x + shares.y + shares.z;
    bias += luminance(difference);
    bright += luminance(truth);
  }
  figures.rel_mse = relative / (3 * count);
  figures.rmse = std::sqrt(square / (3 * count));
  figures.bias = bias / count;
  figures.reference_luminance = bright / count;
}

/// Returns the FLIP figures over a mask; none if the mask is empty.
std::optional<FlipFigures> figures_over(const std::vector<float>& flip, const Mask& mask) {
  std::vector<float> errors;
  double sum = 0;
  for (std::size_t i = 0; i < flip.size(); ++i) {
    if (!mask.inside[i]) continue;
    errors.push_back(flip[i]);
    sum += flip[i];
  }
  if (errors.empty()) return std::nullopt;
  const std::size_t rank = (errors.size() * 95 + 99) / 100 - 1;
  std::nth_element(errors.begin(), errors.begin() + static_cast<std::ptrdiff_t>(rank), errors.end());
  return FlipFigures{sum / static_cast<double>(errors.size()), errors[rank]};
}

}  // namespace

FloatImage as_displayed(const FloatImage& image, const CompareOptions& options) {
  const ToneMap tone_map = image.display_referred ? ToneMap::none : options.tone_map;
  FloatImage displayed{image.width, image.height, std::vector<float>(image.rgba.size(), 1.0f), true};
  for (std::size_t i = 0; i < image.rgba.size(); i += 4) {
    const double alpha = std::clamp(static_cast<double>(image.rgba[i + 3]), 0.0, 1.0);
    for (std::size_t k = 0; k < 3; ++k) {
      const double colour = alpha > 0 ? display_value(image.rgba[i + k] / alpha, tone_map) : 0;
      displayed.rgba[i + k] = static_cast<float>(colour * alpha + options.background * (1 - alpha));
    }
  }
  return displayed;
}

Result<PictureError> compare(const FloatImage& reference, const FloatImage& test, const Mask& mask,
                             const CompareOptions& options) {
  if (Status status = check(reference, test, mask, options); !status.ok()) return status;
  PictureError error;
  error.pixels = mask.count();
  error.coverage = static_cast<double>(error.pixels) / static_cast<double>(mask.inside.size());
  error.non_finite = count_non_finite(reference, test);
  if (error.non_finite > 0) return error;
  error.flip = flip_map(as_displayed(reference, options), as_displayed(test, options), options.pixels_per_degree,
                        options.threads);
  PictureFigures figures;
  figures.flip = *figures_over(error.flip, mask);
  figures.silhouette = figures_over(error.flip, silhouette_band(mask, options.silhouette));
  measure_light(figures, reference, test, mask, options.background);
  error.figures = figures;
  return error;
}

}  // namespace pelage
