#include "server/frames/moved_curves.h"

#include <glm/gtc/matrix_transform.hpp>
#include <numbers>
#include <utility>
#include <vector>

namespace pelage {

namespace {

constexpr float stiffness_of_curves = 8;  // that of fur is 1

double length_of(const std::vector<glm::dvec3>& points) {
  double length = 0;
  for (std::size_t i = 1; i < points.size(); ++i) length += glm::distance(points[i - 1], points[i]);
  return length;
}

/// Returns a unit vector orthogonal to a unit vector, deterministically.
glm::dvec3 across(glm::dvec3 along) {
  const glm::dvec3 other = std::abs(along.y) < 0.9 ? glm::dvec3(0, 1, 0) : glm::dvec3(1, 0, 0);
  return glm::normalize(other - glm::dot(other, along) * along);
}

/// Bends a curve about `axis`: rotates its last segment by `angle`, and earlier segments by less, in proportion to
/// their arc length from the root.
void bend(std::vector<glm::dvec3>& points, double length, glm::dvec3 axis, double angle) {
  double passed = 0;
  glm::dvec3 position = points.front(), before = position;
  for (std::size_t i = 1; i < points.size(); ++i) {
    const glm::dvec3 segment = points[i] - before;
    before = points[i];
    passed += glm::length(segment);
    const glm::dmat3 rotation(glm::rotate(glm::dmat4(1), angle * passed / length, axis));
    points[i] = position += rotation * segment;
  }
}

}  // namespace

BodyMotion motion_under(const FurCurves& curves, const Surface& surface, const BodySwing& swing) {
  std::vector<std::uint32_t> vertices;
  for (const FurGuide& guide : curves.guides)
    vertices.push_back(surface.mesh().triangles[surface.nearest(guide.points.front()).triangle].x);
  const auto acceleration = [vertices = std::move(vertices), of_vertex = swing.acceleration](
                                std::uint32_t curve, double time) { return of_vertex(vertices[curve], time); };
  return {acceleration, swing.step};
}

/// Moves the curves as `swayed` moves strands that stand along them.
void sway_curves(FurCurves& curves, const Wind& wind, double moment, const BodyMotion* body) {
  if (!has_wind(wind) && !body) return;
  std::vector<glm::vec3> roots, along, side;
  std::vector<float> lengths;
  for (const FurGuide& guide : curves.guides) {
    const glm::dvec3 root_to_tip = guide.points.back() - guide.points.front();
    const glm::dvec3 unit = glm::length(root_to_tip) > 1e-9 ? glm::normalize(root_to_tip) : guide.normal;
    roots.emplace_back(guide.points.front()), along.emplace_back(unit), side.emplace_back(across(unit));
    lengths.push_back(static_cast<float>(length_of(guide.points)));
  }
  const std::vector<glm::vec2> upright(roots.size(), glm::vec2(0));
  const std::vector<float> stiffness(roots.size(), stiffness_of_curves);
  const std::vector<glm::vec2> leans = swayed({roots, along, side, upright, lengths, stiffness}, wind, moment, body);
  for (std::size_t i = 0; i < leans.size(); ++i) {
    const double lean = glm::length(glm::dvec2(leans[i]));
    if (!(lean > 0) || !(lengths[i] > 0)) continue;
    const glm::dvec3 up(along[i]), x(side[i]), y = glm::cross(up, x);
    const glm::dvec3 to = (double{leans[i].x} * x + double{leans[i].y} * y) / lean;
    bend(curves.guides[i].points, double{lengths[i]}, glm::normalize(glm::cross(up, to)), lean * std::numbers::pi / 2);
  }
}

}  // namespace pelage
