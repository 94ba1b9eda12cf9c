#include <cmath>
#include <glm/gtc/constants.hpp>

#include "server/fields/field_writer.h"
#include "server/groom/brush.h"
#include "server/groom/tools.h"
#include "server/groom/vertex_frame.h"

namespace pelage {

namespace {

/// Wind from a point into a cone with a soft edge, internal coordinates.
class Blowing {
 public:
  Blowing(const Blow& command, const Mesh& mesh)
      : source_(mesh.to_internal(command.source)),
        axis_(safe_unit(command.direction)),
        outer_(glm::radians(command.cone_degrees)),
        inner_(outer_ * (1 - command.softness)),
        fall_(internal_length(command.fall, command.units, mesh)) {}

  /// Returns the unit direction of the wind at a position; 0 at the source itself.
  glm::dvec3 heading(glm::dvec3 position) const { return safe_unit(position - source_); }

  /// Returns 1 / (1 + (distance / fall)^2), the wind's strength: 1 at the source, half at the distance `fall`.
  double strength(glm::dvec3 position) const {
    if (fall_ == 0) return 1;
    const double away = glm::distance(position, source_) / fall_;
    return 1 / (1 + away * away);
  }

  /// Returns 1 inside the inner cone, falling smoothly to 0 at the edge of the outer one.
  double share(glm::dvec3 heading) const {
    const double angle = std::atan2(glm::length(glm::cross(axis_, heading)), glm::dot(axis_, heading));
    if (angle <= inner_) return 1;
    if (angle >= outer_) return 0;
    const double t = (outer_ - angle) / (outer_ - inner_);
    return t * t * (3 - 2 * t);
  }

 private:
  glm::dvec3 source_, axis_;
  double outer_, inner_;  // half angles of the cones, radians
  double fall_;           // sizes; 0: no falloff
};

}  // namespace

Evaluation run(const Blow& command, const Surface& surface, const FieldSet& fields, const ToolExtras& extras) {
  const Mesh& mesh = surface.mesh();
  const Blowing wind(command, mesh);
  const double sign = command.brush.invert ? -1 : 1;
  FieldWriter writer(fields, Field::direction);
  const Brush brush =
      command.stroke ? command.brush : Brush{.strength = 1};  // without a stroke the wind blows everywhere
  for (const auto [vertex, restriction] : region_of(command.stroke, brush, surface, fields, extras)) {
    const glm::dvec3 position(mesh.positions[vertex]), heading = wind.heading(position);
    const double weight = command.strength * restriction * wind.share(heading) * wind.strength(position);
    if (weight == 0) continue;
    const glm::dvec2 direction(fields.direction()[vertex]);
    writer.put(vertex, leaned_towards(direction, frame_at(mesh, vertex), sign * heading, command.lean, weight));
  }
  Evaluation done;
  writer.finish(done.delta);
  return done;
}

}  // namespace pelage
