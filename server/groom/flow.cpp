#include <algorithm>
#include <cmath>

#include "server/fields/field_writer.h"
#include "server/groom/keys.h"
#include "server/groom/region.h"
#include "server/groom/tools.h"
#include "server/groom/vertex_frame.h"
#include "server/surface/corners_around.h"
#include "server/surface/parallel.h"

namespace pelage {

namespace {

constexpr double step = 0.01;          // sizes between places along a curve
constexpr std::size_t most_steps = 4096;  // on one curve

/// Corners around the places that a curve passes, with the way that it goes there.
std::vector<SpreadSource> sources_of(const std::vector<glm::dvec3>& curve, const Surface& surface) {
  const Mesh& mesh = surface.mesh();
  std::vector<SpreadSource> sources;
  for (std::size_t i = 1; i < curve.size(); ++i) {
    const glm::dvec3 from = mesh.to_internal(curve[i - 1]), to = mesh.to_internal(curve[i]);
    const glm::dvec3 way = safe_unit(to - from);
    const double wanted = std::ceil(glm::distance(from, to) / step);
    const auto pieces = static_cast<std::size_t>(std::clamp(wanted, 1.0, static_cast<double>(most_steps)));
    for (std::size_t k = 0; k <= pieces; ++k) {
      const SurfacePoint place =
          surface.nearest(glm::mix(from, to, static_cast<double>(k) / static_cast<double>(pieces)));
      const glm::dvec3 on_surface = surface.position(place);
      for (const std::uint32_t v : corners_around(surface, place)) {
        const VertexFrame frame = frame_at(mesh, v);
        const glm::dvec2 part = frame.tangent_part(way);
        if (glm::length(part) < no_heading) continue;
        const glm::dvec2 heading = glm::normalize(part);
        sources.push_back({v, glm::distance(on_surface, glm::dvec3(mesh.positions[v])),
                           heading.x * frame.tangent + heading.y * frame.bitangent});
      }
    }
  }
  return sources;
}

}  // namespace

Evaluation flow(const Flow& command, const Surface& surface, const FieldSet& fields) {
  const Mesh& mesh = surface.mesh();
  const double sigma = internal_length(command.sigma, command.units, mesh);
  const Brush brush = command.stroke ? command.brush : Brush{.strength = 1};
  std::vector<Spread> spreads(command.curves.size());
  const Spreader spreader(surface, command.distance);
  for_each_in_parallel(static_cast<std::uint32_t>(spreads.size()),
                       [&](std::uint32_t k) { spreads[k] = spreader(sources_of(command.curves[k], surface)); });
  FieldWriter directions(fields, Field::direction);
  std::vector<double> distances(spreads.size()), weights(spreads.size());
  for (const auto [v, restriction] : region_of(command.stroke, brush, surface, fields)) {
    for (std::size_t k = 0; k < spreads.size(); ++k) distances[k] = spreads[k].distance[v];
    gaussian_weights(distances, sigma, weights);
    glm::dvec3 way(0);
    for (std::size_t k = 0; k < spreads.size(); ++k) way += weights[k] * spreads[k].vector[v];
    const glm::dvec2 direction(fields.direction()[v]);
    const double lean = command.inclination.value_or(glm::length(direction));
    directions.put(v, turned(direction, frame_at(mesh, v), way, lean, command.strength * restriction));
  }
  Evaluation done;
  directions.finish(done.delta);
  return done;
}

}  // namespace pelage
