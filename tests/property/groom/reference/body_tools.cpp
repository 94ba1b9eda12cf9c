// Tools that work on the whole body: keys, curves and neighbours.
#include <algorithm>
#include <cmath>
#include <limits>

#include "tests/property/groom/reference/brush.h"
#include "tests/property/groom/reference/spread.h"
#include "tests/property/groom/reference/tools.h"

namespace pelage::plain {

namespace {

Reach reach(const Body& body, DistanceKind kind, const std::vector<Corner>& corners) {
  return kind == DistanceKind::straight ? reach_through_space(body, corners) : reach_along_edges(body, corners);
}

/// Adds the corners around the surface point nearest to `position`. Each gets the tangent part of the unit vector
/// `direction`, scaled to `length`.
void add_corners(const Body& body, dvec3 position, dvec3 direction, double length, bool all,
                 std::vector<Corner>& corners) {
  const SurfacePoint nearest = body.surface.nearest(position);
  const dvec3 there = body.surface.position(nearest);
  for (const Vertex v : corners_of(body, nearest)) {
    const dvec2 part = body.in_frame(v, direction);
    const bool heads = glm::length(part) >= 1e-6;
    if (!heads && !all) continue;
    const dvec3 vector = heads ? body.in_space(v, part * (length / glm::length(part))) : dvec3(0);
    corners.push_back({v, glm::distance(there, body.positions[v]), vector});
  }
}

std::vector<Corner> corners_of(const Key& key, const Body& body) {
  std::vector<Corner> corners;
  const dvec3 direction = key.direction ? unit(*key.direction) : dvec3(0);
  add_corners(body, body.inside(key.position), direction, key.inclination.value_or(0.5), true, corners);
  return corners;
}

/// Corners around points on the curve that are at most a hundredth of the size apart.
std::vector<Corner> corners_of(const std::vector<dvec3>& curve, const Body& body) {
  std::vector<Corner> corners;
  for (std::size_t i = 0; i + 1 < curve.size(); ++i) {
    const dvec3 from = body.inside(curve[i]), to = body.inside(curve[i + 1]);
    const int steps = static_cast<int>(std::clamp(std::ceil(glm::distance(from, to) / 0.01), 1.0, 4096.0));
    for (int k = 0; k <= steps; ++k) {
      const double t = static_cast<double>(k) / steps;
      add_corners(body, (1 - t) * from + t * to, unit(to - from), 1, false, corners);
    }
  }
  return corners;
}

/// Distances of the keys for which `speaks` returns true; infinite for the others.
template <class Speaks>
std::vector<double> key_distances(const Interpolate& command, const std::vector<Reach>& reaches, Vertex v,
                                  Speaks speaks) {
  std::vector<double> distances;
  for (std::size_t k = 0; k < reaches.size(); ++k)
    distances.push_back(speaks(command.keys[k]) ? reaches[k].distance[v] : std::numeric_limits<double>::infinity());
  return distances;
}

/// 1 if the nearest distance is within half of the reach, 0 beyond the reach, and a cubic in between.
template <class Guides>
double share_within_reach(const Guides& command, const Body& body, const std::vector<double>& distances) {
  if (!command.reach) return 1;
  const double nearest = *std::min_element(distances.begin(), distances.end());
  const double half = body.sizes(*command.reach, command.units) / 2;
  if (nearest <= half) return 1;
  if (nearest >= 2 * half) return 0;
  const double left = (2 * half - nearest) / half;
  return left * left * (3 - 2 * left);
}

bool any(const std::vector<double>& weights) {
  return std::any_of(weights.begin(), weights.end(), [](double w) { return w > 0; });
}

/// Inverse distances of a vertex's neighbours.
std::vector<double> nearness(const Body& body, Vertex v) {
  std::vector<double> inverse;
  for (const Vertex other : body.neighbours[v])
    inverse.push_back(1 / glm::distance(body.positions[v], body.positions[other]));
  return inverse;
}

dvec4 neighbours_mean(const Body& body, Field field, const std::vector<dvec4>& values, Vertex v) {
  const std::vector<double> inverse = nearness(body, v);
  dvec4 sum(0);
  double whole = 0;
  std::size_t k = 0;
  for (const Vertex other : body.neighbours[v]) {
    dvec4 value = values[other];
    if (field == Field::direction) {
      const dvec3 lean = brought(body.in_space(other, dvec2(value)), body.normals[other], body.normals[v]);
      value = dvec4(body.in_frame(v, lean), 0, 0);
    }
    sum += inverse[k] * value;
    whole += inverse[k++];
  }
  return whole > 0 ? sum / whole : values[v];
}

void smooth_once(const Smooth& command, const Body& body, Field field, const std::vector<double>& region, Fur& fur) {
  const std::vector<dvec4> before = fur.of(field);
  for (Vertex v = 0; v < body.size(); ++v) {
    const double t = command.t * region[v];
    if (t == 0) continue;
    dvec4 after = (1 - t) * before[v] + t * neighbours_mean(body, field, before, v);
    if (field == Field::direction && command.keep_inclination) {
      const double length = glm::length(after);
      after = length > 1e-6 ? after * (glm::length(before[v]) / length) : before[v];
    }
    fur.of(field)[v] = after;
  }
}

}  // namespace

void apply(const Interpolate& command, const Stage& stage, Fur& fur) {
  const Body& body = stage.body;
  const double sigma = body.sizes(command.sigma, command.units);
  const std::vector<double> region = restriction_of(command.stroke, command.brush, stage, fur);
  std::vector<Reach> reaches;
  for (const Key& key : command.keys) reaches.push_back(reach(body, command.distance, corners_of(key, body)));
  for (Vertex v = 0; v < body.size(); ++v) {
    const double w = command.strength * region[v];
    const auto direct_distances =
        key_distances(command, reaches, v, [](const Key& key) { return key.direction.has_value(); });
    const auto length_distances =
        key_distances(command, reaches, v, [](const Key& key) { return key.length.has_value(); });
    const auto directed = gaussians(direct_distances, sigma), measured = gaussians(length_distances, sigma);
    dvec3 lean(0);
    double length = 0;
    for (std::size_t k = 0; k < reaches.size(); ++k) {
      lean += directed[k] * reaches[k].vector[v];
      length += measured[k] * body.sizes(command.keys[k].length.value_or(0), command.units);
    }
    if (any(directed)) {
      const double share = w * share_within_reach(command, body, direct_distances);
      fur.of(Field::direction)[v] = dvec4((1 - share) * fur.direction(v) + share * body.in_frame(v, lean), 0, 0);
    }
    if (any(measured)) {
      const double share = w * share_within_reach(command, body, length_distances);
      fur.of(Field::length)[v].x = (1 - share) * fur.number(Field::length, v) + share * length;
    }
  }
}

void apply(const Flow& command, const Stage& stage, Fur& fur) {
  const Body& body = stage.body;
  const double sigma = body.sizes(command.sigma, command.units);
  const std::vector<double> region = restriction_of(command.stroke, command.brush, stage, fur);
  std::vector<Reach> reaches;
  for (const std::vector<dvec3>& curve : command.curves)
    reaches.push_back(reach(body, command.distance, corners_of(curve, body)));
  for (Vertex v = 0; v < body.size(); ++v) {
    std::vector<double> distances;
    for (const Reach& one : reaches) distances.push_back(one.distance[v]);
    const std::vector<double> weights = gaussians(distances, sigma);
    dvec3 direction(0);
    for (std::size_t k = 0; k < reaches.size(); ++k) direction += weights[k] * reaches[k].vector[v];
    const double lean = command.inclination.value_or(glm::length(fur.direction(v)));
    const dvec2 after = turned_to(body, v, fur.direction(v), direction, lean,
                                  command.strength * region[v] * share_within_reach(command, body, distances));
    fur.of(Field::direction)[v] = dvec4(after, 0, 0);
  }
}

void apply(const Smooth& command, const Stage& stage, Fur& fur) {
  const std::vector<double> region = region_of(command.stroke, command.brush, stage, fur);
  fur.multiply_colours();
  for (const Field field : command.fields) {
    std::vector<double> reached = region;
    for (double& weight : reached) weight *= strand_part(command.brush, field);
    for (int pass = 0; pass < command.passes; ++pass) smooth_once(command, stage.body, field, reached, fur);
  }
  fur.divide_colours();
}

}  // namespace pelage::plain
