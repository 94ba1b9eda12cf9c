#include <algorithm>
#include <cmath>

#include "base/parallel.h"
#include "server/fields/field_writer.h"
#include "server/groom/brush.h"
#include "server/groom/keys.h"
#include "server/groom/tools.h"
#include "server/groom/vertex_frame.h"
#include "server/surface/geodesics.h"

namespace pelage {

namespace {

constexpr double step = 0.01;            // distance between sampled positions along a curve, sizes
constexpr std::size_t max_steps = 4096;  // maximum for each segment of a curve

/// Returns the corners around the points of a curve as sources, with the curve's direction there.
std::vector<SpreadSource> sources_of(const std::vector<glm::dvec3>& curve, const Surface& surface) {
  const Mesh& mesh = surface.mesh();
  std::vector<SpreadSource> sources;
  for (std::size_t i = 1; i < curve.size(); ++i) {
    const glm::dvec3 from = mesh.to_internal(curve[i - 1]), to = mesh.to_internal(curve[i]);
    const glm::dvec3 direction = safe_unit(to - from);
    const double wanted = std::ceil(glm::distance(from, to) / step);
    const auto steps = static_cast<std::size_t>(std::clamp(wanted, 1.0, static_cast<double>(max_steps)));
    for (std::size_t k = 0; k <= steps; ++k) {
      const SurfacePoint point =
          surface.nearest(glm::mix(from, to, static_cast<double>(k) / static_cast<double>(steps)));
      const glm::dvec3 on_surface = surface.position(point);
      for (const std::uint32_t v : corners_around(surface, point)) {
        const VertexFrame frame = frame_at(mesh, v);
        const glm::dvec2 part = frame.tangent_part(direction);
        if (glm::length(part) < no_heading) continue;
        const glm::dvec2 heading = glm::normalize(part);
        sources.push_back({v, glm::distance(on_surface, glm::dvec3(mesh.positions[v])),
                           heading.x * frame.tangent + heading.y * frame.bitangent});
      }
    }
  }
  return sources;
}

/// Returns the mean direction of all curves at the region's vertices.
std::vector<GaussianMean<glm::dvec3>> mean_directions(const Flow& command, const Surface& surface,
                                                      const std::vector<VertexWeight>& region, const Cancel& cancel) {
  const double sigma = internal_length(command.sigma, command.units, surface.mesh());
  const Spreader spreader(surface, command.distance);
  std::vector<GaussianMean<glm::dvec3>> means(region.size());
  std::vector<Spread> spreads;
  for (std::size_t first = 0; first < command.curves.size(); first += spread_batch_size) {
    cancel.check();
    spreads.resize(std::min(spread_batch_size, command.curves.size() - first));
    for_each_in_parallel(static_cast<std::uint32_t>(spreads.size()), [&](std::uint32_t k) {
      spreads[k] = spreader(sources_of(command.curves[first + k], surface));
    });
    for_each_range_in_parallel(static_cast<std::uint32_t>(region.size()), [&](std::uint32_t begin, std::uint32_t end) {
      for (std::uint32_t i = begin; i < end; ++i) {
        const std::uint32_t v = region[i].vertex;
        means[i].add(
            spreads.size(), sigma, [&](std::size_t k) { return spreads[k].distance[v]; },
            [&](std::size_t k) { return spreads[k].vector[v]; });
      }
    });
  }
  return means;
}

}  // namespace

Evaluation run(const Flow& command, const Surface& surface, const FieldSet& fields, const ToolExtras& extras) {
  const Brush brush = command.stroke ? command.brush : Brush{.strength = 1};
  const std::vector<VertexWeight> region = region_of(command.stroke, brush, surface, fields, extras);
  Evaluation done;
  if (region.empty()) return done;
  const std::vector<GaussianMean<glm::dvec3>> means = mean_directions(command, surface, region, extras.cancel);
  const std::optional<double> reach = internal_length(command.reach, command.units, surface.mesh());
  write_in_parallel(fields, Field::direction, static_cast<std::uint32_t>(region.size()), done.delta,
                    [&](std::uint32_t i, FieldWriter& directions) {
                      const auto [v, restriction] = region[i];
                      const double share = reach_falloff(reach, means[i].nearest());
                      if (!means[i].reached() || share == 0) return false;
                      const glm::dvec2 direction(fields.direction()[v]);
                      const double lean = command.inclination.value_or(glm::length(direction));
                      return directions.put(v, leaned_towards(direction, frame_at(surface.mesh(), v), means[i].mean(),
                                                              lean, command.strength * restriction * share));
                    });
  return done;
}

}  // namespace pelage
