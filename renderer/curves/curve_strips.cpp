#include "renderer/curves/curve_strips.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <numbers>

#include "base/random.h"

namespace pelage {

glm::dvec3 spline_point(std::span<const glm::dvec3> points, double t) {
  assert(points.size() >= 2);
  const std::size_t last = points.size() - 1;
  const double along = std::clamp(t, 0.0, 1.0) * static_cast<double>(last);
  const std::size_t i = std::min(static_cast<std::size_t>(along), last - 1);
  const double x = along - static_cast<double>(i);
  const glm::dvec3 b = points[i], c = points[i + 1];
  const glm::dvec3 a = i > 0 ? points[i - 1] : 2.0 * b - c, d = i + 2 <= last ? points[i + 2] : 2.0 * c - b;
  if (x == 1) return c;
  return b + 0.5 * x * (c - a + x * (2.0 * a - 5.0 * b + 4.0 * c - d + x * (3.0 * (b - c) + d - a)));
}

namespace {

constexpr std::size_t points_of_curve = curve_segments + 1;
constexpr double max_turn = std::numbers::pi / 6, max_growth = 0.5;  // limits for filled curves at a spread of 1

/// An evaluated guide, or a mix of two.
struct Curve {
  std::vector<glm::dvec3> positions;
  glm::dvec3 normal;
};

Curve evaluated(const FurGuide& guide) {
  Curve curve{{}, guide.normal};
  for (std::size_t i = 0; i < points_of_curve; ++i)
    curve.positions.push_back(spline_point(guide.points, static_cast<double>(i) / curve_segments));
  return curve;
}

Curve mixed(const Curve& a, const Curve& b, double at) {
  Curve curve{{}, glm::mix(a.normal, b.normal, at)};
  for (std::size_t i = 0; i < points_of_curve; ++i)
    curve.positions.push_back(glm::mix(a.positions[i], b.positions[i], at));
  const double length = glm::length(curve.normal);
  curve.normal = length > 1e-9 ? curve.normal / length : a.normal;
  return curve;
}

/// Returns a vector rotated by `angle`, radians, about a unit axis (Rodrigues).
glm::dvec3 turned(glm::dvec3 v, glm::dvec3 axis, double angle) {
  const double c = std::cos(angle);
  return v * c + glm::cross(axis, v) * std::sin(angle) + axis * (glm::dot(axis, v) * (1 - c));
}

/// Varies a curve's length and rotates it about its root, which stays.
void stray(Curve& curve, double spread, Random& random) {
  const double growth = 1 + max_growth * spread * random.uniform(-1, 1), angle = max_turn * spread * random.uniform();
  const glm::dvec3 any(random.uniform(-1, 1), random.uniform(-1, 1), random.uniform(-1, 1));
  const glm::dvec3 root = curve.positions.front(), across = glm::cross(curve.positions.back() - root, any);
  const double length = glm::length(across);
  const glm::dvec3 axis = length > 1e-30 ? across / length : glm::dvec3(0, 1, 0);
  for (glm::dvec3& position : curve.positions) position = root + growth * turned(position - root, axis, angle);
}

void append(const Curve& curve, const FurCurves& group, double number, CurveStrips& strips) {
  for (const glm::dvec3& position : curve.positions) strips.points.emplace_back(position);
  strips.styles.push_back({glm::vec4(group.root_colour, group.width_root), glm::vec4(group.tip_colour, group.width_tip),
                           glm::vec4(glm::vec3(curve.normal), number)});
}

void append_group(const FurCurves& group, CurveStrips& strips) {
  std::uint64_t number = 0;
  for (std::size_t g = 0; g < group.guides.size(); ++g) {
    const Curve guide = evaluated(group.guides[g]);
    append(guide, group, Random(group.seed, number++).uniform(), strips);
    if (g + 1 == group.guides.size()) break;
    const Curve next = group.fill > 0 ? evaluated(group.guides[g + 1]) : guide;
    for (int k = 1; k <= group.fill; ++k) {
      Random random(group.seed, number++);
      const double own = random.uniform(), aside = group.spread * random.uniform(-0.5, 0.5);
      Curve curve = mixed(guide, next, (k + aside) / (group.fill + 1));
      stray(curve, group.spread, random);
      append(curve, group, own, strips);
    }
  }
}

}  // namespace

CurveStrips make_strips(std::span<const FurCurves> groups) {
  CurveStrips strips;
  for (const FurCurves& group : groups) append_group(group, strips);
  return strips;
}

}  // namespace pelage
