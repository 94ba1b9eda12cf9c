#include <algorithm>
#include <limits>

#include "base/parallel.h"
#include "server/fields/field_writer.h"
#include "server/groom/brush.h"
#include "server/groom/keys.h"
#include "server/groom/tools.h"
#include "server/groom/vertex_frame.h"
#include "server/surface/geodesics.h"

namespace pelage {

namespace {

constexpr double default_inclination = 0.5;

/// Returns the corners around a key as sources. Their vectors are the key's direction in the surface there, with the
/// inclination as length.
std::vector<SpreadSource> sources_of(const Key& key, const Surface& surface) {
  const Mesh& mesh = surface.mesh();
  const glm::dvec3 position = mesh.to_internal(key.position);
  const SurfacePoint nearest = surface.nearest(position);
  const glm::dvec3 on_surface = surface.position(nearest);
  std::vector<SpreadSource> sources;
  for (const std::uint32_t v : corners_around(surface, nearest)) {
    glm::dvec3 lean(0);
    if (key.direction) {
      const VertexFrame frame = frame_at(mesh, v);
      const glm::dvec2 part = frame.tangent_part(safe_unit(*key.direction));
      const double along = glm::length(part);
      if (along > no_heading)
        lean =
            key.inclination.value_or(default_inclination) / along * (part.x * frame.tangent + part.y * frame.bitangent);
    }
    sources.push_back({v, glm::distance(on_surface, glm::dvec3(mesh.positions[v])), lean});
  }
  return sources;
}

/// The weighted means of all keys at one vertex.
struct KeyMeans {
  GaussianMean<glm::dvec3> lean;
  GaussianMean<double> length;  // sizes
};

/// Returns the means of the keys at the region's vertices. Keys without a direction do not count for the direction, and
/// keys without a length not for the length.
std::vector<KeyMeans> key_means(const Interpolate& command, const Surface& surface,
                                const std::vector<VertexWeight>& region, const Cancel& cancel) {
  constexpr double no_value = std::numeric_limits<double>::infinity();
  const double sigma = internal_length(command.sigma, command.units, surface.mesh());
  const Spreader spreader(surface, command.distance);
  std::vector<KeyMeans> means(region.size());
  std::vector<Spread> spreads;
  for (std::size_t first = 0; first < command.keys.size(); first += spread_batch_size) {
    cancel.check();
    const std::span keys =
        std::span(command.keys).subspan(first, std::min(spread_batch_size, command.keys.size() - first));
    spreads.resize(keys.size());
    for_each_in_parallel(static_cast<std::uint32_t>(keys.size()),
                         [&](std::uint32_t k) { spreads[k] = spreader(sources_of(keys[k], surface)); });
    for_each_range_in_parallel(static_cast<std::uint32_t>(region.size()), [&](std::uint32_t begin, std::uint32_t end) {
      for (std::uint32_t i = begin; i < end; ++i) {
        const std::uint32_t v = region[i].vertex;
        means[i].lean.add(
            keys.size(), sigma, [&](std::size_t k) { return keys[k].direction ? spreads[k].distance[v] : no_value; },
            [&](std::size_t k) { return spreads[k].vector[v]; });
        means[i].length.add(
            keys.size(), sigma, [&](std::size_t k) { return keys[k].length ? spreads[k].distance[v] : no_value; },
            [&](std::size_t k) { return internal_length(*keys[k].length, command.units, surface.mesh()); });
      }
    });
  }
  return means;
}

}  // namespace

Evaluation run(const Interpolate& command, const Surface& surface, const FieldSet& fields, const ToolExtras& extras) {
  const Brush brush = command.stroke ? command.brush : Brush{.strength = 1};
  const std::vector<VertexWeight> region = region_of(command.stroke, brush, surface, fields, extras);
  Evaluation done;
  if (region.empty()) return done;
  const std::vector<KeyMeans> means = key_means(command, surface, region, extras.cancel);
  const auto count = static_cast<std::uint32_t>(region.size());
  const std::optional<double> reach = internal_length(command.reach, command.units, surface.mesh());
  const auto strength_at = [&](std::uint32_t i, double distance) {
    return command.strength * region[i].weight * reach_falloff(reach, distance);
  };
  write_in_parallel(fields, Field::direction, count, done.delta, [&](std::uint32_t i, FieldWriter& directions) {
    const std::uint32_t v = region[i].vertex;
    const double strength = strength_at(i, means[i].lean.nearest());
    if (!means[i].lean.reached() || strength == 0) return false;
    const glm::dvec2 towards = frame_at(surface.mesh(), v).tangent_part(means[i].lean.mean());
    return directions.put(v, glm::dvec2(glm::mix(glm::dvec2(fields.direction()[v]), towards, strength)));
  });
  done.clamped +=
      write_in_parallel(fields, Field::length, count, done.delta, [&](std::uint32_t i, FieldWriter& lengths) {
        const std::uint32_t v = region[i].vertex;
        const double strength = strength_at(i, means[i].length.nearest());
        if (!means[i].length.reached() || strength == 0) return false;
        return lengths.put(v, glm::mix(double{fields.length()[v]}, means[i].length.mean(), strength));
      });
  return done;
}

}  // namespace pelage
