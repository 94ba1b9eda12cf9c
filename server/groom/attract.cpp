#include <algorithm>
#include <cmath>
#include <glm/gtc/constants.hpp>

#include "base/lean_curve.h"
#include "server/fields/field_writer.h"
#include "server/groom/brush.h"
#include "server/groom/tools.h"
#include "server/groom/vertex_frame.h"

namespace pelage {

namespace {

/// Returns the unit tangent at a strand's tip. Its angle from the normal is the inclination times a right angle.
glm::dvec3 tip_tangent(glm::dvec2 direction, const VertexFrame& frame) {
  const auto [inclination, lean] = lean_of(direction, frame.normal, frame.tangent);
  const double angle = inclination * glm::half_pi<double>();
  return std::cos(angle) * frame.normal + std::sin(angle) * lean;
}

/// Returns a direction turned as comb turns it, towards the inclination at which the tip points along the pull.
glm::dvec2 turned_to_pull(glm::dvec2 direction, const VertexFrame& frame, glm::dvec3 pull, double weight) {
  const double across = glm::length(frame.tangent_part(pull)), up = glm::dot(pull, frame.normal);
  if (across < no_heading) return up > 0 ? direction * (1 - weight) : direction;
  const double lean = std::min(1.0, std::atan2(across, up) / glm::half_pi<double>());
  return leaned_towards(direction, frame, pull, lean, weight);
}

/// Returns the growth factor of the length for a stretch, without a limit.
double growth(double stretch, double threshold) { return 1 + std::max(0.0, stretch - threshold); }

/// Writes the three fields that the attract tool changes.
class Stick {
 public:
  Stick(const Attract& command, const FieldSet& fields)
      : command_(command),
        fields_(fields),
        direction_(fields, Field::direction),
        length_(fields, Field::length),
        stretch_(fields, Field::stretch) {}

  /// Pulls the fur of a vertex along the unit vector `pull`.
  void pull(std::uint32_t vertex, const VertexFrame& frame, glm::dvec3 pull, double weight) {
    const Groom fur = fields_.at(vertex);
    const glm::dvec2 direction(fur.direction);
    const double along = std::max(0.0, glm::dot(pull, tip_tangent(direction, frame)));
    direction_.put(vertex, turned_to_pull(direction, frame, pull, 1 - std::pow(1 - weight, command_.duration)));
    pull_out(vertex, fur, weight * command_.duration * along);
  }

  Evaluation finish() {
    Evaluation done{{}, clamped_};
    direction_.finish(done.delta), length_.finish(done.delta), stretch_.finish(done.delta);
    return done;
  }

 private:
  /// Adds the part of the pull along the strand to the stretch, and stretch over the threshold to the length.
  void pull_out(std::uint32_t vertex, const Groom& fur, double added) {
    const double before = growth(fur.stretch, command_.threshold);
    const double after = growth(fur.stretch + added, command_.threshold);
    const double ratio = std::min(after, command_.max_stretch) / std::min(before, command_.max_stretch);
    bool clamped = after > before && after > command_.max_stretch;
    clamped = length_.put(vertex, fur.length * ratio) || clamped;
    clamped = stretch_.put(vertex, fur.stretch + added) || clamped;
    clamped_ += clamped;
  }

  const Attract& command_;
  const FieldSet& fields_;
  FieldWriter direction_, length_, stretch_;
  std::size_t clamped_ = 0;
};

/// Returns the vertices under the stroke or, without a stroke, all around the point.
std::vector<VertexWeight> reach_of(const Attract& command, const Surface& surface, const FieldSet& fields,
                                   glm::dvec3 point, double radius, const ToolExtras& extras) {
  if (command.stroke) return region_of(command.stroke, command.brush, surface, fields, extras);
  std::vector<std::uint32_t> found;
  surface.vertices_within(point, radius, found);
  std::vector<VertexWeight> all;
  all.reserve(found.size());
  for (const std::uint32_t v : found) all.push_back({v, fields.number(Field::mask, v)});
  return all;
}

}  // namespace

Evaluation run(const Attract& command, const Surface& surface, const FieldSet& fields, const ToolExtras& extras) {
  const Mesh& mesh = surface.mesh();
  const glm::dvec3 point = mesh.to_internal(command.point);
  const double radius = internal_length(command.radius, command.units, mesh);
  const double sign = command.brush.invert ? -1 : 1;
  if (!(radius > 0)) return {};
  Stick stick(command, fields);
  for (const auto [vertex, restriction] : reach_of(command, surface, fields, point, radius, extras)) {
    const glm::dvec3 to_point = point - glm::dvec3(mesh.positions[vertex]);
    const double weight =
        command.strength * restriction * falloff_weight(command.brush, glm::length(to_point) / radius);
    if (weight == 0) continue;
    stick.pull(vertex, frame_at(mesh, vertex), sign * safe_unit(to_point), weight);
  }
  return stick.finish();
}

}  // namespace pelage
