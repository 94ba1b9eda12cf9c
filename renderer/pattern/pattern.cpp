#include "renderer/pattern/pattern.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "base/colour_space.h"
#include "renderer/coat/strand_tile.h"
#include "renderer/pattern/cells.h"

namespace pelage {

float gradient_noise(glm::vec3 position, std::uint32_t stream, std::uint32_t seed) {
  const glm::vec3 low = glm::floor(position), f = position - low;
  const glm::vec3 w = f * f * f * (f * (f * 6.0f - 15.0f) + 10.0f);
  const CellNumbers<8> random = numbers_of(corner_cells(glm::ivec3(low)), stream, seed);
  std::array<float, 8> slope;
  for (std::uint32_t i = 0; i < slope.size(); ++i) {
    const float x = f.x - static_cast<float>(i & 1), y = f.y - static_cast<float>(i >> 1 & 1),
                z = f.z - static_cast<float>(i >> 2);
    slope[i] = (2 * random.x[i] - 1) * x + (2 * random.y[i] - 1) * y + (2 * random.z[i] - 1) * z;
  }
  const auto across = [&](std::size_t i) { return glm::mix(slope[i], slope[i + 1], w.x); };
  return glm::mix(glm::mix(across(0), across(2), w.y), glm::mix(across(4), across(6), w.y), w.z);
}

float cell_distance(glm::vec3 position, glm::vec3 normal, std::uint32_t stream, std::uint32_t seed) {
  const glm::ivec3 cell(glm::floor(position - 0.5f));
  const CellNumbers<8> random = numbers_of(corner_cells(cell), stream, seed);
  float nearest = 0.62f;
  for (std::size_t i = 0; i < 8; ++i) {
    const glm::vec3 at = glm::vec3(cell + glm::ivec3(i & 1, i >> 1 & 1, i >> 2));
    const glm::vec3 apart = at + 0.2f + 0.6f * glm::vec3(random.x[i], random.y[i], random.z[i]) - position;
    const float off = glm::dot(apart, normal);
    const float size =
        (0.8f + 0.3f * glm::fract(random.x[i] * 16.0f)) * (1 - glm::smoothstep(0.3f, 0.5f, glm::abs(off)));
    nearest = glm::min(nearest, glm::length(apart - off * normal) / glm::max(size, 1e-3f));
  }
  return nearest;
}

namespace {

float largest_wet_luminance(const Coat& coat) {
  float largest = 1e-4f;
  for (const RampStop& stop : coat.ramp) largest = std::max(largest, luminance(wet_colour(coat, stop.colour)));
  return largest;
}

/// Returns the radius of discs, about .8 scattered on a unit square, that cover a share of it; above .55 they would
/// have to touch.
double spot_radius(double coverage) {
  return std::min(0.5, std::sqrt(-std::log1p(-std::min(coverage, 0.95)) / (0.8 * std::numbers::pi)));
}

/// Returns the threshold below which the sum of both noises (standard deviations .19 and, by warp, .1) lies with a
/// probability of the coverage, by a logistic curve close to the normal distribution. For a coverage of 0 and 1 it is
/// beyond all values of noise.
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
  block.axis = {glm::vec3(glm::normalize(pattern.axis)), 1 / largest_wet_luminance(coat)};
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

namespace {

/// Evaluates a block's pattern.
class Evaluator {
 public:
  explicit Evaluator(const PatternBlock& block) : block_(block) {}

  glm::vec2 marks(glm::vec3 position, glm::vec3 normal) const;
  glm::vec3 weights(glm::vec3 position, glm::vec3 normal) const;

  float swell(glm::vec3 position, std::uint32_t stream) const {
    return glm::clamp(1.8f * noise(block_.derived.x * position, stream), -1.0f, 1.0f);
  }

 private:
  PatternKind kind() const { return static_cast<PatternKind>(block_.head.x); }
  float noise(glm::vec3 position, std::uint32_t stream) const {
    return gradient_noise(position, stream, block_.head.y);
  }
  float per_size() const { return block_.shape.x; }
  float coverage() const { return block_.shape.y; }
  float softness() const { return block_.shape.z; }
  float warp() const { return block_.shape.w; }
  float soft() const { return softness() * glm::min(coverage(), 1 - coverage()) + 1e-3f; }

  /// 1 where x is below the threshold, with a soft edge of the given half width.
  static float below(float x, float threshold, float half_width) {
    return 1 - glm::smoothstep(threshold - half_width, threshold + half_width, x);
  }

  float on_legs(glm::vec3 position) const { return block_.amounts.z * (1 - glm::smoothstep(-0.2f, -0.1f, position.y)); }
  float stripe_count(glm::vec3 position) const;
  float stripe(glm::vec3 position, float ragged) const;
  float spot(glm::vec3 position, glm::vec3 normal) const;
  float patch(glm::vec3 position, std::uint32_t stream) const;
  glm::vec2 stripes(glm::vec3 position) const;
  glm::vec2 tabby(glm::vec3 position, glm::vec3 normal) const;
  glm::vec2 rosettes(glm::vec3 position, glm::vec3 normal) const;
  float under(glm::vec3 position, glm::vec3 normal, float reach, float half_width) const;
  glm::vec3 countershading(glm::vec3 position, glm::vec3 normal) const;

  const PatternBlock& block_;
};

/// Returns the number of stripes up to a position along the axis. On legs and haunches they bend to lie around the leg,
/// on haunches swept to the rump.
float Evaluator::stripe_count(glm::vec3 position) const {
  const float along = glm::dot(position, glm::vec3(block_.axis));
  const float haunch = 1 - glm::smoothstep(-0.25f, 0.0f, along);
  const float drop = glm::max(glm::mix(-0.08f, 0.06f, haunch) - position.y, 0.0f);
  const float turned = along + 2.4f * block_.amounts.z * glm::mix(1.0f, -1.0f, haunch) * drop * drop / (drop + 0.08f);
  return turned * per_size() + 2 * warp() * noise(0.4f * per_size() * position, 0);
}

/// Returns 0 in the middle of a stripe and 1 between stripes. Noise stretched along the stripes joins, splits and ends
/// them.
float Evaluator::stripe(glm::vec3 position, float ragged) const {
  const float count = stripe_count(position);
  const glm::vec3 axis(block_.axis);
  const glm::vec3 drawn_out = 0.3f * per_size() * (position - axis * glm::dot(position, axis)) + axis * (0.8f * count);
  const float between = glm::abs(glm::fract(count) - 0.5f) * 2;
  return between + 4 * coverage() * (1 - coverage()) * ragged * warp() * noise(drawn_out, 1);
}

glm::vec2 Evaluator::stripes(glm::vec3 position) const {
  const float at = stripe(position, 1.8f);
  return {below(at, coverage(), soft()), glm::smoothstep(0.78f, 0.9f, at)};
}

glm::vec2 Evaluator::tabby(glm::vec3 position, glm::vec3 normal) const {
  const float breaks = 2.4f * coverage() * (1 - coverage()) * warp() * noise(0.8f * per_size() * position, 2);
  const float broken = stripe(position, 2.6f) + breaks;
  const float line = below(glm::abs(position.x) * per_size(), 0.5f * coverage(), soft());
  const float spine = line * glm::smoothstep(0.2f, 0.5f, normal.y);
  return {glm::max(below(broken, coverage(), soft()), spine), glm::smoothstep(0.7f, 0.9f, broken)};
}

/// Returns the distance from the middle of a spot: 1 at its edge, which noise makes uneven.
float Evaluator::spot(glm::vec3 position, glm::vec3 normal) const {
  const glm::vec3 at = position * per_size();
  const float uneven = 1 + 0.9f * warp() * noise(2.0f * at, 4);
  return cell_distance(at, normal, 3, block_.head.y) * uneven / glm::max(block_.derived.y, 1e-4f);
}

/// Returns rosettes: rings that are broken in places; on the legs they are filled, and smaller.
glm::vec2 Evaluator::rosettes(glm::vec3 position, glm::vec3 normal) const {
  const float legs = on_legs(position), half_width = 0.5f * softness() + 1e-3f;
  const float at = spot(position, normal) * (1 + 0.5f * legs);
  const float disc = below(at, 1, half_width), hollow = below(at, 0.62f, half_width);
  const float gap = below(noise(1.9f * per_size() * position, 5), -0.07f, 0.05f);
  return {glm::mix(disc * (1 - hollow) * (1 - gap), disc, legs), disc};
}

float Evaluator::patch(glm::vec3 position, std::uint32_t stream) const {
  const glm::vec3 at = 0.6f * per_size() * position;
  const float ragged = 0.5f * warp() * noise(2.7f * at, stream + 1);
  return below(noise(at, stream) + ragged, block_.derived.z, 0.2f * softness() + 1e-3f);
}

glm::vec2 Evaluator::marks(glm::vec3 position, glm::vec3 normal) const {
  switch (kind()) {
    case PatternKind::stripes: return stripes(position);
    case PatternKind::spots: return {below(spot(position, normal), 1, 0.5f * softness() + 1e-3f), 0};
    case PatternKind::rosettes: return rosettes(position, normal);
    case PatternKind::tabby: return tabby(position, normal);
    case PatternKind::patches: return {patch(position, 6), patch(position, 8)};
    case PatternKind::none:
    case PatternKind::countershading: break;
  }
  return glm::vec2(0);
}

/// Returns 1 on downward and low skin, 0 on the back; `reach` in [0, 1] is how far up it extends.
float Evaluator::under(glm::vec3 position, glm::vec3 normal, float reach, float half_width) const {
  const float down = -0.9f * normal.y - 0.5f * position.y + 0.25f * noise(9.0f * position, 10);
  const float threshold = glm::mix(1.4f, -1.4f, reach);
  return glm::smoothstep(threshold - half_width, threshold + half_width, down);
}

glm::vec3 Evaluator::countershading(glm::vec3 position, glm::vec3 normal) const {
  const float half_width = 0.1f + softness(), reach = coverage();
  const float back = 1 - under(position, normal, glm::min(reach + 0.3f, 1.0f), half_width);
  return {0, block_.amounts.y * back, block_.amounts.x * under(position, normal, reach, half_width)};
}

glm::vec3 Evaluator::weights(glm::vec3 position, glm::vec3 normal) const {
  if (kind() == PatternKind::none) return glm::vec3(0);
  if (kind() == PatternKind::countershading) return countershading(position, normal);
  const float lower = block_.amounts.w > 0 ? block_.amounts.w * under(position, normal, 0.36f, 0.25f) : 0;
  const glm::vec2 here = (1 - lower) * marks(position, normal);
  return {lower, block_.amounts.y * here.y, block_.amounts.x * here.x};
}

}  // namespace

glm::vec3 pattern_weights(const PatternBlock& block, glm::vec3 position, glm::vec3 normal) {
  return Evaluator(block).weights(position, normal);
}

glm::vec3 with_weights(const PatternBlock& block, glm::vec3 weights, glm::vec3 base) {
  const float shade = 0.36f + 0.84f * luminance(base) * block.axis.w;
  glm::vec3 colour = glm::mix(base, glm::vec3(block.belly_colour) * shade, weights.x);
  colour = glm::mix(colour, glm::vec3(block.inner_colour) * shade, weights.y);
  return glm::mix(colour, glm::vec3(block.colour) * shade, weights.z);
}

glm::vec4 pattern_variation(const PatternBlock& block, glm::vec3 position) {
  const float hue = block.variation.y > 0 ? block.variation.y * Evaluator(block).swell(position, 12) / 3 : 0;
  const float lightness =
      block.variation.x > 0 ? std::exp2(block.variation.x * Evaluator(block).swell(position, 11)) : 1;
  return {pattern_length(block, position), pattern_lean(block, position), lightness, hue};
}

float pattern_length(const PatternBlock& block, glm::vec3 position) {
  return block.variation.z > 0 ? 1 + block.variation.z * Evaluator(block).swell(position, 13) : 1;
}

float pattern_lean(const PatternBlock& block, glm::vec3 position) {
  return block.variation.w > 0 ? block.variation.w * Evaluator(block).swell(position, 14) : 0;
}

}  // namespace pelage
