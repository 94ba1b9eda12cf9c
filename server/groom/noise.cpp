#include <algorithm>
#include <bit>
#include <optional>

#include "base/random.h"
#include "server/fields/field_writer.h"
#include "server/groom/brush.h"
#include "server/groom/tools.h"
#include "server/groom/vertex_frame.h"
#include "server/surface/value_noise.h"

namespace pelage {

namespace {

/// Random numbers that depend on positions and not on vertex numbers.
class PlacedNoise {
 public:
  PlacedNoise(const Noise& command, const Mesh& mesh)
      : seed_(command.seed), feature_(internal_length(command.feature_size, command.units, mesh)) {}

  /// The random numbers at one position.
  class Numbers {
   public:
    Numbers(const PlacedNoise& noise, glm::vec3 position) : seed_(noise.seed_) {
      constexpr double finest = 1e-8;  // sizes; a finer lattice exceeds the range of value_noise
      if (noise.feature_ >= finest)
        lattice_.emplace(glm::dvec3(position) / noise.feature_);
      else
        position_hash_ = mix_bits(bits(position.x) << 32 | bits(position.y)) ^ bits(position.z);
    }

    /// Returns a number in [-1, 1], a different one for each channel.
    double operator()(std::uint64_t channel) const {
      const std::uint64_t stream = mix_bits(seed_ ^ (channel << 32));
      return lattice_ ? (*lattice_)(stream) : Random(stream, position_hash_).uniform(-1, 1);
    }

   private:
    static std::uint64_t bits(float x) { return std::bit_cast<std::uint32_t>(x + 0.0f); }

    std::uint64_t seed_, position_hash_ = 0;
    std::optional<ValueNoise> lattice_;
  };
  Numbers at(glm::vec3 position) const { return {*this, position}; }

 private:
  std::uint64_t seed_;
  double feature_;  // sizes
};

/// Adds the tangential part of a random vector in the cube [-1, 1]^3, times `amount`, to the direction.
glm::dvec4 disturbed_direction(glm::dvec2 direction, const PlacedNoise& noise, const Mesh& mesh, std::uint32_t v,
                               double amount) {
  const PlacedNoise::Numbers numbers = noise.at(mesh.positions[v]);
  const glm::dvec3 random(numbers(0), numbers(1), numbers(2));
  return glm::dvec4(direction + amount * frame_at(mesh, v).tangent_part(random), 0, 0);
}

}  // namespace

Evaluation run(const Noise& command, const Surface& surface, const FieldSet& fields, const ToolExtras& extras) {
  const Mesh& mesh = surface.mesh();
  const PlacedNoise random(command, mesh);
  const std::vector<VertexWeight> region = region_of(command.stroke, command.brush, surface, fields, extras);
  Evaluation done;
  for (std::size_t f = 0; f < field_count; ++f) {
    const Field field = field_at(f);
    if (std::count(command.fields.begin(), command.fields.end(), field) == 0) continue;
    const bool relative =
        field == Field::length || field == Field::width || field == Field::stretch || field == Field::stiffness;
    const auto count = static_cast<std::uint32_t>(region.size());
    done.clamped += write_in_parallel(fields, field, count, done.delta, [&](std::uint32_t i, FieldWriter& writer) {
      const auto [v, weight] = region[i];
      const double amount =
          strand_share(command.brush, field) * command.amount * weight * (command.brush.invert ? -1 : 1);
      glm::dvec4 value(fields.value(field, v));
      if (field == Field::direction)
        return writer.put(v, disturbed_direction(glm::dvec2(value), random, mesh, v, amount));
      const PlacedNoise::Numbers numbers = random.at(mesh.positions[v]);
      for (int c = 0; c < shape_of(field).channels; ++c) {
        const double change = amount * numbers(8 * f + static_cast<std::size_t>(c));
        value[c] += relative ? change * value[c] : change;
      }
      return writer.put(v, value);
    });
  }
  return done;
}

}  // namespace pelage
