#include <cmath>
#include <limits>

#include "server/fields/field_writer.h"
#include "server/groom/keys.h"
#include "server/groom/region.h"
#include "server/groom/tools.h"
#include "server/groom/vertex_frame.h"
#include "server/surface/corners_around.h"
#include "server/surface/parallel.h"

namespace pelage {

namespace {

constexpr double default_inclination = 0.5;

/// The corners around a key as sources: the direction in the surface there, with its inclination as length.
std::vector<SpreadSource> sources_of(const Key& key, const Surface& surface) {
  const Mesh& mesh = surface.mesh();
  const glm::dvec3 place = mesh.to_internal(key.position);
  const SurfacePoint nearest = surface.nearest(place);
  const glm::dvec3 on_surface = surface.position(nearest);
  std::vector<SpreadSource> sources;
  for (const std::uint32_t v : corners_around(surface, nearest)) {
    glm::dvec3 lean(0);
    if (key.direction) {
      const VertexFrame frame = frame_at(mesh, v);
      const glm::dvec2 part = frame.tangent_part(safe_unit(*key.direction));
      const double along = glm::length(part);
      if (along > no_heading)
        lean = key.inclination.value_or(default_inclination) / along * (part.x * frame.tangent + part.y * frame.bitangent);
    }
    sources.push_back({v, glm::distance(on_surface, glm::dvec3(mesh.positions[v])), lean});
  }
  return sources;
}

/// What all keys together say at one vertex.
struct Said {
  double lean_weight = 0, length_weight = 0;  // 0: no key with one reaches it
  glm::dvec3 lean{0};
  double length = 0;
};

/// The keys spread over the surface.
class SpreadKeys {
 public:
  SpreadKeys(const Interpolate& command, const Surface& surface)
      : keys_(command.keys),
        sigma_(internal_length(command.sigma, command.units, surface.mesh())),
        spreads_(command.keys.size()) {
    const Spreader spreader(surface, command.distance);
    for_each_in_parallel(static_cast<std::uint32_t>(keys_.size()),
                         [&](std::uint32_t k) { spreads_[k] = spreader(sources_of(keys_[k], surface)); });
    for (const Key& key : keys_)
      lengths_.push_back(key.length ? internal_length(*key.length, command.units, surface.mesh()) : 0);
  }

  /// Keys without a direction say nothing about it, and those without a length nothing about that.
  Said at(std::uint32_t vertex, std::vector<double>& distances, std::vector<double>& weights) const {
    Said said;
    weigh(vertex, [](const Key& key) { return key.direction.has_value(); }, distances, weights);
    for (std::size_t k = 0; k < keys_.size(); ++k)
      said.lean += weights[k] * spreads_[k].vector[vertex], said.lean_weight += weights[k];
    weigh(vertex, [](const Key& key) { return key.length.has_value(); }, distances, weights);
    for (std::size_t k = 0; k < keys_.size(); ++k)
      said.length += weights[k] * lengths_[k], said.length_weight += weights[k];
    return said;
  }

  std::size_t count() const { return keys_.size(); }

 private:
  template <class Speaks>
  void weigh(std::uint32_t vertex, Speaks speaks, std::vector<double>& distances, std::vector<double>& weights) const {
    constexpr double silent = std::numeric_limits<double>::infinity();
    for (std::size_t k = 0; k < keys_.size(); ++k)
      distances[k] = speaks(keys_[k]) ? spreads_[k].distance[vertex] : silent;
    gaussian_weights(distances, sigma_, weights);
  }

  const std::vector<Key>& keys_;
  double sigma_;  // sizes
  std::vector<Spread> spreads_;
  std::vector<double> lengths_;  // sizes
};

}  // namespace

Evaluation interpolate(const Interpolate& command, const Surface& surface, const FieldSet& fields) {
  const Brush brush = command.stroke ? command.brush : Brush{.strength = 1};
  const SpreadKeys keys(command, surface);
  FieldWriter directions(fields, Field::direction), lengths(fields, Field::length);
  std::vector<double> distances(keys.count()), weights(keys.count());
  Evaluation done;
  for (const auto [v, restriction] : region_of(command.stroke, brush, surface, fields)) {
    const double weight = command.strength * restriction;
    const Said said = keys.at(v, distances, weights);
    const Groom fur = fields.at(v);
    if (said.lean_weight > 0) {
      const glm::dvec2 towards = frame_at(surface.mesh(), v).tangent_part(said.lean);
      directions.put(v, glm::dvec2(glm::mix(glm::dvec2(fur.direction), towards, weight)));
    }
    if (said.length_weight > 0) done.clamped += lengths.put(v, glm::mix(double{fur.length}, said.length, weight));
  }
  directions.finish(done.delta), lengths.finish(done.delta);
  return done;
}

}  // namespace pelage
