#include <algorithm>
#include <bit>

#include "protocol/base/random.h"
#include "server/fields/field_writer.h"
#include "server/groom/region.h"
#include "server/groom/tools.h"
#include "server/groom/vertex_frame.h"
#include "server/surface/value_noise.h"

namespace pelage {

namespace {

/// Random numbers that belong to places, and not to the numbers of vertices.
class PlacedNoise {
 public:
  PlacedNoise(const Noise& command, const Mesh& mesh)
      : seed_(command.seed), feature_(internal_length(command.feature_size, command.units, mesh)) {}

  /// In [-1, 1], another one for each `channel`.
  double at(glm::vec3 position, std::uint64_t channel) const {
    constexpr double finest = 1e-8;  // sizes; below it the lattice leaves the range of value_noise
    const std::uint64_t stream = mix_bits(seed_ ^ (channel << 32));
    if (feature_ >= finest) return value_noise(glm::dvec3(position) / feature_, stream);
    const auto bits = [](float x) { return std::uint64_t{std::bit_cast<std::uint32_t>(x + 0.0f)}; };
    const std::uint64_t place = mix_bits(bits(position.x) << 32 | bits(position.y)) ^ bits(position.z);
    return Random(stream, place).uniform(-1, 1);
  }

 private:
  std::uint64_t seed_;
  double feature_;  // sizes
};

/// A random vector in the unit cube, its part in the surface added to the direction.
glm::dvec4 disturbed_direction(glm::dvec2 direction, const PlacedNoise& noise, const Mesh& mesh, std::uint32_t v,
                               double amount) {
  const glm::vec3 position = mesh.positions[v];
  const glm::dvec3 random(noise.at(position, 0), noise.at(position, 1), noise.at(position, 2));
  return glm::dvec4(direction + amount * frame_at(mesh, v).tangent_part(random), 0, 0);
}

}  // namespace

Evaluation noise(const Noise& command, const Surface& surface, const FieldSet& fields) {
  const Mesh& mesh = surface.mesh();
  const PlacedNoise random(command, mesh);
  const std::vector<VertexWeight> region = region_of(command.stroke, command.brush, surface, fields);
  Evaluation done;
  for (std::size_t f = 0; f < field_count; ++f) {
    const Field field = field_at(f);
    if (std::count(command.fields.begin(), command.fields.end(), field) == 0) continue;
    const bool relative = field == Field::length || field == Field::width || field == Field::stretch;
    FieldWriter writer(fields, field);
    for (const auto [v, weight] : region) {
      const double amount = command.amount * weight * (command.brush.invert ? -1 : 1);
      glm::dvec4 value(fields.value(field, v));
      if (field == Field::direction) {
        value = disturbed_direction(glm::dvec2(value), random, mesh, v, amount);
      } else {
        for (int c = 0; c < shape_of(field).channels; ++c) {
          const double change = amount * random.at(mesh.positions[v], 8 * f + static_cast<std::size_t>(c));
          value[c] += relative ? change * value[c] : change;
        }
      }
      done.clamped += writer.put(v, value);
    }
    writer.finish(done.delta);
  }
  return done;
}

}  // namespace pelage
