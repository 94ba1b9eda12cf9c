#include <algorithm>
#include <cassert>
#include <string>

#include "server/fields/field_set.h"
#include "server/fields/field_writer.h"
#include "server/groom/brush.h"
#include "server/groom/tools.h"
#include "server/maps/draw_map.h"
#include "server/maps/uv_corners.h"

namespace pelage {

namespace {

/// Returns whether the map applies to no vertex, because none lies in its tile.
bool applies_nowhere(const MapTargets& targets) {
  const std::vector<bool>& silent = targets.outside_tile;
  return !silent.empty() && std::find(silent.begin(), silent.end(), false) == silent.end();
}

std::string no_such_tile(const Mesh& mesh, int tile) {
  std::string message = "the model has nothing in tile " + std::to_string(tile) + "; its tiles are";
  for (const int udim : udims_of(make_uv_corners(mesh))) message += " " + std::to_string(udim);
  return message;
}

}  // namespace

// Blends each value V with the picture's M: (1 - w) V + w M, which is exactly M at full strength.
Evaluation run(const ApplyMap& command, const Surface& surface, const FieldSet& fields, const ToolExtras& extras) {
  assert(extras.picture != nullptr);
  const Mesh& mesh = surface.mesh();
  const MapEncoding encoding = encoding_of(command.field, command.encoding);
  const bool is_length = command.field == Field::length || encoding == MapEncoding::vector;
  const double scale = is_length ? internal_length(command.scale, command.units, mesh) : command.scale;
  const MapTargets targets = read_map(mesh, *extras.picture, command.field, encoding, scale, command.tile);
  Brush everywhere;
  everywhere.strength = command.strength;
  const Masked masked = command.field == Field::mask ? Masked::no : Masked::yes;
  const std::vector<VertexWeight> region = region_of({}, everywhere, surface, fields, extras, masked);
  Evaluation done;
  if (applies_nowhere(targets)) done.warnings.push_back(no_such_tile(mesh, command.tile));
  for (const Field field : targets.fields) {
    FieldWriter writer(fields, field);
    for (const auto [v, weight] : region) {
      if (!targets.outside_tile.empty() && targets.outside_tile[v]) continue;
      if (field == Field::direction && !targets.no_direction.empty() && targets.no_direction[v]) continue;
      const glm::dvec4 now = to_summable(field, glm::dvec4(fields.value(field, v)));
      const glm::dvec4 there = to_summable(field, targets.values[static_cast<std::size_t>(field)][v]);
      done.clamped += writer.put(v, from_summable(field, (1 - weight) * now + weight * there));
    }
    writer.finish(done.delta);
  }
  return done;
}

}  // namespace pelage
