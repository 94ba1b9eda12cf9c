#include <algorithm>
#include <cmath>
#include <glm/gtc/constants.hpp>

#include "server/groom/brush.h"
#include "server/groom/tools.h"
#include "server/groom/vertex_frame.h"
#include "server/groom/working_set.h"

namespace pelage {

namespace {

/// The tip's tangent, unit: its angle from the normal is the inclination times a right angle.
glm::dvec3 tip_tangent(glm::dvec2 direction, const VertexFrame& frame) {
  const double inclination = glm::length(direction);
  if (inclination == 0) return frame.normal;
  const double angle = inclination * glm::half_pi<double>();
  const glm::dvec2 heading = direction / inclination;
  return std::cos(angle) * frame.normal + std::sin(angle) * (heading.x * frame.tangent + heading.y * frame.bitangent);
}

/// The turning part: as comb does, towards the inclination at which the tip points along the pull.
glm::dvec2 turned_to_pull(glm::dvec2 direction, const VertexFrame& frame, glm::dvec3 pull, double weight) {
  const double across = glm::length(frame.tangent_part(pull)), up = glm::dot(pull, frame.normal);
  if (across < no_heading) return up > 0 ? direction * (1 - weight) : direction;
  const double lean = std::min(1.0, std::atan2(across, up) / glm::half_pi<double>());
  return turned(direction, frame, pull, lean, weight);
}

/// How much longer fur is than before any stretch, without a limit.
double growth(double stretch, double threshold) { return 1 + std::max(0.0, stretch - threshold); }

/// The part along the strand adds up to stretch, and stretch over the threshold to length. True when length was held
/// at its limit.
bool pull_out(WorkingSet::Fur& fur, const Attract& command, double added) {
  const double before = growth(fur.stretch, command.threshold);
  fur.stretch += added;
  const double after = growth(fur.stretch, command.threshold);
  fur.length *= std::min(after, command.max_stretch) / std::min(before, command.max_stretch);
  return after > before && after > command.max_stretch;
}

std::vector<VertexWeight> reach(const Attract& command, const Surface& surface, glm::dvec3 point, double radius) {
  if (command.stroke) return coverage(*command.stroke, command.brush, surface);
  std::vector<std::uint32_t> found;
  if (radius > 0) surface.vertices_within(point, radius, found);
  std::vector<VertexWeight> all;
  all.reserve(found.size());
  for (const std::uint32_t v : found) all.push_back({v, 1.0});
  return all;
}

}  // namespace

Evaluation attract(const Attract& command, const Surface& surface, const FieldSet& fields) {
  const Mesh& mesh = surface.mesh();
  const glm::dvec3 point = mesh.to_internal(command.point);
  const double radius = internal_length(command.radius, command.units, mesh);
  const double sign = command.brush.invert ? -1 : 1;
  WorkingSet work(fields);
  std::size_t clamped = 0;
  if (!(radius > 0)) return {};
  for (const auto [vertex, restriction] : reach(command, surface, point, radius)) {
    const glm::dvec3 to_point = point - glm::dvec3(mesh.positions[vertex]);
    const double weight =
        command.strength * restriction * falloff_weight(command.brush.falloff, glm::length(to_point) / radius);
    if (weight == 0) continue;
    const VertexFrame frame = frame_at(mesh, vertex);
    const glm::dvec3 pull = sign * safe_unit(to_point);
    WorkingSet::Fur& fur = work.at(vertex);
    const double along = std::max(0.0, glm::dot(pull, tip_tangent(fur.direction, frame)));
    fur.direction = turned_to_pull(fur.direction, frame, pull, 1 - std::pow(1 - weight, command.duration));
    clamped += pull_out(fur, command, weight * command.duration * along);
  }
  return {work.delta(), clamped};
}

}  // namespace pelage
