#include <algorithm>
#include <limits>

#include "tests/property/groom/reference/spread.h"
#include "tests/property/groom/reference/tools.h"

namespace pelage::plain {

namespace {

/// How much each shape selects a vertex, [0, 1].
struct Chosen {
  const ChangeMask& command;
  const Body& body;
  Vertex v;

  double operator()(const MaskAll&) const { return 1; }
  double operator()(const MaskVertices& list) const {
    return std::find(list.vertices.begin(), list.vertices.end(), v) != list.vertices.end() ? 1 : 0;
  }
  double operator()(const MaskBox& box) const {
    const dvec3 p = body.positions[v], low = body.inside(box.min), high = body.inside(box.max);
    for (int k = 0; k < 3; ++k) {
      if (p[k] < low[k] || p[k] > high[k]) return 0;
    }
    return 1;
  }
  double operator()(const MaskSphere& sphere) const {
    const double radius = body.sizes(sphere.radius, command.units);
    const double distance = glm::distance(body.positions[v], body.inside(sphere.centre));
    if (distance > radius) return 0;
    const double soft = radius * sphere.softness;
    return soft > 0 ? std::min(1.0, (radius - distance) / soft) : 1;
  }
  double operator()(const MaskPart& part) const {
    const Vertex corner = body.triangles[body.surface.nearest(body.inside(part.position)).triangle][0];
    return reach_along_edges(body, {{corner, 0, dvec3(0)}}).distance[v] < std::numeric_limits<double>::infinity();
  }
  double operator()(const MaskMaterial&) const { return 0; }  // tests/unit/groom has models with materials
  double operator()(const MaskPicture&) const { return 0; }   // tests/unit/maps reads pictures
};

double combined(MaskCombine combine, double now, double chosen, double value) {
  if (combine == MaskCombine::add) return std::min(1.0, now + chosen * value);
  if (combine == MaskCombine::subtract) return std::max(0.0, now - chosen * value);
  if (combine == MaskCombine::intersect) return now * chosen * value;
  return chosen * value + (1 - chosen) * (1 - value);
}

/// The largest value, or with `min` the smallest, within a distance along edges.
std::vector<double> spread(const Body& body, const std::vector<double>& mask, double distance, bool min) {
  std::vector<double> after = mask;
  for (Vertex v = 0; v < body.size(); ++v) {
    const Reach reach = reach_along_edges(body, {{v, 0, dvec3(0)}});
    for (Vertex other = 0; other < body.size(); ++other) {
      if (reach.distance[other] > distance) continue;
      after[v] = min ? std::min(after[v], mask[other]) : std::max(after[v], mask[other]);
    }
  }
  return after;
}

std::vector<double> smoothed(const Body& body, std::vector<double> mask, int passes) {
  for (int pass = 0; pass < passes; ++pass) {
    const std::vector<double> before = mask;
    for (Vertex v = 0; v < body.size(); ++v) {
      double mean = 0;
      for (const Vertex other : body.neighbours[v])
        mean += before[other] / static_cast<double>(body.neighbours[v].size());
      if (!body.neighbours[v].empty()) mask[v] = (before[v] + mean) / 2;
    }
  }
  return mask;
}

}  // namespace

void apply(const ChangeMask& command, const Stage& stage, Fur& fur) {
  const Body& body = stage.body;
  const double distance = body.sizes(command.distance, command.units);
  std::vector<double> mask;
  for (Vertex v = 0; v < body.size(); ++v) mask.push_back(fur.number(Field::mask, v));
  if (command.action == MaskAction::grow) mask = spread(body, mask, distance, false);
  if (command.action == MaskAction::shrink) mask = spread(body, mask, distance, true);
  if (command.action == MaskAction::smooth) mask = smoothed(body, mask, command.passes);
  for (Vertex v = 0; v < body.size(); ++v) {
    if (command.action == MaskAction::invert) mask[v] = 1 - mask[v];
    if (command.action == MaskAction::select)
      mask[v] = combined(command.combine, mask[v], std::visit(Chosen{command, body, v}, command.shape), command.value);
    fur.of(Field::mask)[v].x = mask[v];
  }
}

}  // namespace pelage::plain
