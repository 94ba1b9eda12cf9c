#include "renderer/compare/compare.h"

#include <algorithm>
#include <cmath>
#include <string>

#include "renderer/compare/colour.h"
#include "renderer/compare/flip.h"

namespace pelage {

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
  if (!is_within(options.outline, 0, 1000)) {
    return failure(Code::invalid, "The width of the outline is out of range.", "/outline", "[0, 1000]");
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

/// The filmic curve of the resolve pass (passes/resolve/resolve.frag).
double film(double x) {
  x = std::min(x, 1e4) * 0.72;
  return x * (2.51 * x + 0.03) / (x * (2.43 * x + 0.59) + 0.14);
}

double shown(double value, ToneMap tone_map) {
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
  double count = 0, relative = 0, square = 0, bias = 0, luminance = 0;
  for (std::size_t i = 0; i < mask.inside.size(); ++i) {
    if (!mask.inside[i]) continue;
    const glm::dvec3 truth = over_background(reference, i, background);
    const glm::dvec3 difference = over_background(test, i, background) - truth;
    const glm::dvec3 squares = difference * difference, shares = squares / (truth * truth + epsilon);
    count += 1;
    square += squares.x + squares.y + squares.z;
    relative += shares.x + shares.y + shares.z;
    bias += luminance_of(difference);
    luminance += luminance_of(truth);
  }
  figures.rel_mse = relative / (3 * count);
  figures.rmse = std::sqrt(square / (3 * count));
  figures.bias = bias / count;
  figures.reference_luminance = luminance / count;
}

/// None where the mask is empty.
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
      const double colour = alpha > 0 ? shown(image.rgba[i + k] / alpha, tone_map) : 0;
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
  figures.outline = figures_over(error.flip, outline_band(mask, options.outline));
  measure_light(figures, reference, test, mask, options.background);
  error.figures = figures;
  return error;
}

Result<PictureError> compare(const Image& reference, const Image& test, const Mask& mask,
                             const CompareOptions& options) {
  return compare(linear_image(reference), linear_image(test), mask, options);
}

}  // namespace pelage
