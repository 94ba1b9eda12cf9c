#include "tests/property/groom/reference/standing.h"

#include <algorithm>
#include <cmath>

namespace pelage::plain {

namespace {

constexpr double standing_pi = 3.14159265358979323846;

}  // namespace

dvec2 lean_position(const Coat& coat, double inclination, double s) {
  const double tip = inclination * standing_pi / 2, a0 = coat.root_share * tip, a = tip - a0;
  if (a < 1e-7) return s * dvec2(std::sin(a0), std::cos(a0));
  const double chord = s * std::sin(a * s / 2) / (a * s / 2);
  if (coat.lean_curve == LeanCurve::arc) return chord * dvec2(std::sin(a0 + a * s / 2), std::cos(a0 + a * s / 2));
  const auto g = [](double u) { return u * std::sqrt(1 + u * u) + std::asinh(u); };
  const double u1 = 2 * std::tan(a / 2), k2 = 4 / g(u1);
  double low = 0, high = u1;
  for (int halving = 0; halving < 60; ++halving) {
    const double middle = (low + high) / 2;
    (g(middle) < s * g(u1) ? low : high) = middle;
  }
  const double y = k2 * low / 2, x = k2 * low * low / 4;
  return {std::cos(a0) * x + std::sin(a0) * y, std::cos(a0) * y - std::sin(a0) * x};
}

std::optional<Standing> standing_of(const Brush& brush, const Stage& stage, const Fur& fur) {
  if (brush.reach != pelage::Reach::fur) return std::nullopt;
  Standing standing;
  for (Vertex v = 0; v < stage.body.size(); ++v) {
    const dvec2 lean = fur.direction(v);
    const dvec3 sideways = unit(stage.body.in_space(v, lean));
    Standing::Strand& strand = standing.strands.emplace_back();
    strand[0] = {stage.body.positions[v], 0};
    for (std::size_t k = 1; k < strand.size(); ++k) {
      const dvec2 position = lean_position(stage.coat, std::min(glm::length(lean), 1.0), static_cast<double>(k) / 8);
      const dvec3 offset = position.x * sideways + position.y * stage.body.normals[v];
      strand[k] = {stage.body.positions[v] + fur.number(Field::length, v) * offset, position.y};
    }
  }
  return standing;
}

Standing::StrandPoint nearest_of(const Standing::Strand& strand, dvec3 position) {
  Standing::StrandPoint nearest = strand[0];
  for (std::size_t k = 1; k < strand.size(); ++k) {
    const dvec3 start = strand[k - 1].at, segment = strand[k].at - start;
    const double square = glm::dot(segment, segment);
    if (square == 0) continue;
    const double t = std::clamp(glm::dot(position - start, segment) / square, 0.0, 1.0);
    const Standing::StrandPoint here{start + t * segment, (1 - t) * strand[k - 1].lift + t * strand[k].lift};
    if (glm::distance(here.at, position) < glm::distance(nearest.at, position)) nearest = here;
  }
  return nearest;
}

}  // namespace pelage::plain
