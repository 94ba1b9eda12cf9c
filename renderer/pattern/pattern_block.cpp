#include "renderer/pattern/pattern_block.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "renderer/coat/wetness.h"

namespace pelage {

namespace {

float largest_luminance(const Coat& coat) {
  float largest = 1e-4f;
  for (const RampStop& stop : coat.ramp) {
    largest = std::max(largest, glm::dot(wet_colour(coat, stop.colour), {0.2126f, 0.7152f, 0.0722f}));
  }
  return largest;
}

/// Of discs scattered about .8 to a unit square that cover this share of it; over .55 they would have to touch.
double spot_radius(double coverage) {
  return std::min(0.5, std::sqrt(-std::log1p(-std::min(coverage, 0.95)) / (0.8 * std::numbers::pi)));
}

/// Below which the sum of both noises (standard deviations .19 and, by warp, .1) is with a chance of the coverage: the
/// logistic curve close to the normal one. Beyond all values of noise for a coverage of 0 and 1.
double patch_threshold(const Pattern& pattern) {
  const double coverage = std::clamp(pattern.coverage, 1e-9, 1 - 1e-9);
  const double deviation = 0.19 * std::hypot(1.0, 0.5 * pattern.warp);
  return deviation * std::log(coverage / (1 - coverage)) / 1.702;
}

}  // namespace

PatternBlock make_pattern_block(const Coat& coat) {
  const Pattern& pattern = coat.pattern;
  const Variation& variation = coat.variation;
  PatternBlock block;
  block.head = {static_cast<unsigned>(pattern.kind), pattern.seed, 0, 0};
  block.shape = glm::vec4(1 / pattern.scale, pattern.coverage, pattern.softness, pattern.warp);
  block.amounts = glm::vec4(pattern.contrast, pattern.inner, pattern.legs, pattern.belly);
  block.axis = {glm::vec3(glm::normalize(pattern.axis)), 1 / largest_luminance(coat)};
  block.colour = {wet_colour(coat, pattern.colour), 1};
  block.inner_colour = {wet_colour(coat, pattern.inner_colour), 1};
  block.belly_colour = {wet_colour(coat, pattern.belly_colour), 1};
  if (pattern.kind == PatternKind::countershading) block.colour = block.belly_colour;  // its marking is the underside
  block.variation = glm::vec4(variation.lightness, variation.hue, variation.length, variation.lean);
  block.derived = glm::vec4(1 / variation.size, spot_radius(pattern.coverage), patch_threshold(pattern), 0);
  return block;
}

bool has_pattern(const Coat& coat) {
  const Variation& v = coat.variation;
  return coat.pattern.kind != PatternKind::none || v.lightness > 0 || v.hue > 0 || v.length > 0 || v.lean > 0;
}

}  // namespace pelage
