#include <algorithm>

#include "server/fields/field_set.h"
#include "server/fields/field_writer.h"
#include "server/groom/brush.h"
#include "server/groom/tools.h"
#include "server/groom/vertex_frame.h"

namespace pelage {

namespace {

glm::dvec3 in_space(const VertexFrame& frame, glm::dvec2 direction) {
  return direction.x * frame.tangent + direction.y * frame.bitangent;
}

/// The weighted mean of a field over a region; for directions the mean heading in space and the mean inclination.
struct Mean {
  glm::dvec4 value{0};
  glm::dvec3 heading{0};
  double inclination = 0;
};

Mean mean_of(Field field, const std::vector<VertexWeight>& region, const Mesh& mesh, const FieldSet& fields) {
  Mean mean;
  double sum = 0;
  for (const auto [v, weight] : region) {
    const glm::dvec4 value = to_summable(field, glm::dvec4(fields.value(field, v)));
    mean.value += weight * value;
    sum += weight;
    if (field != Field::direction) continue;
    mean.heading += weight * in_space(frame_at(mesh, v), glm::dvec2(value));
    mean.inclination += weight * glm::length(glm::dvec2(value));
  }
  mean.value /= sum, mean.inclination /= sum;
  mean.heading = safe_unit(mean.heading);
  return mean;
}

/// Returns a direction turned towards a heading in space and an inclination. Where one of them is absent, the fur keeps
/// its own.
glm::dvec2 unified(glm::dvec2 direction, const VertexFrame& frame, const std::optional<glm::dvec3>& heading,
                   const std::optional<double>& inclination, double weight) {
  const double own = glm::length(direction), lean = inclination.value_or(own);
  if (heading) return leaned_towards(direction, frame, *heading, lean, weight);
  return own > no_heading ? direction * (1 + weight * (lean / own - 1)) : direction;
}

struct Target {
  std::optional<glm::dvec3> heading;
  std::optional<double> inclination;
};

}  // namespace

Evaluation run(const Unify& command, const Surface& surface, const FieldSet& fields, const ToolExtras& extras) {
  const Mesh& mesh = surface.mesh();
  const std::vector<VertexWeight> region = region_of(command.stroke, command.brush, surface, fields, extras);
  Evaluation done;
  if (region.empty() || command.weight == 0) return done;
  const auto to_mean = [&](Field field) { return std::count(command.mean.begin(), command.mean.end(), field) > 0; };
  Target target{command.direction ? std::optional(safe_unit(*command.direction)) : std::nullopt, command.inclination};
  for (std::size_t f = 0; f < field_count; ++f) {
    const Field field = field_at(f);
    const bool value = (field == Field::direction && (target.heading || target.inclination)) ||
                       (field == Field::length && command.length);
    if (!value && !to_mean(field)) continue;
    const Mean mean = value ? Mean{} : mean_of(field, region, mesh, fields);
    if (field == Field::direction && !value) target = {mean.heading, mean.inclination};
    const glm::dvec4 goal = value && command.length
                                ? glm::dvec4(internal_length(*command.length, command.units, mesh), 0, 0, 0)
                                : mean.value;
    const auto count = static_cast<std::uint32_t>(region.size());
    done.clamped += write_in_parallel(fields, field, count, done.delta, [&](std::uint32_t i, FieldWriter& writer) {
      const auto [v, restriction] = region[i];
      const double weight = strand_share(command.brush, field) * command.weight * restriction;
      const glm::dvec4 now = to_summable(field, glm::dvec4(fields.value(field, v)));
      if (field != Field::direction) return writer.put(v, from_summable(field, now + weight * (goal - now)));
      return writer.put(v, unified(glm::dvec2(now), frame_at(mesh, v), target.heading, target.inclination, weight));
    });
  }
  return done;
}

}  // namespace pelage
