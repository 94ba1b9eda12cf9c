#include <algorithm>
#include <bit>
#include <cassert>

#include "base/random.h"
#include "server/fields/field_writer.h"
#include "server/groom/brush.h"
#include "server/groom/tools.h"

namespace pelage {

namespace {

/// Returns a random number in [-1, 1] that depends on the position and not on the vertex number.
double random_at(glm::vec3 position, std::uint32_t seed) {
  const auto bits = [](float x) { return std::uint64_t{std::bit_cast<std::uint32_t>(x + 0.0f)}; };
  const std::uint64_t position_hash = mix_bits(bits(position.x) << 32 | bits(position.y)) ^ bits(position.z);
  return Random(seed, position_hash).uniform(-1, 1);
}

double weighted_mean(const std::vector<VertexWeight>& region, const FieldSet& fields) {
  double sum = 0, weights = 0;
  for (const auto [v, weight] : region) sum += weight * fields.length()[v], weights += weight;
  return weights > 0 ? sum / weights : 0;
}

/// Returns the new length at full strength of the brush.
double goal_of(const Length& command, double length, double value, double mean, glm::vec3 position) {
  const bool invert = command.brush.invert;
  switch (command.mode) {
    case LengthMode::set: return value;
    case LengthMode::add: return invert ? length - value : length + value;
    case LengthMode::scale: return invert ? (value > 0 ? length / value : length) : length * value;
    case LengthMode::average: return mean;
    case LengthMode::jitter: return length * (1 + value * random_at(position, command.seed) * (invert ? -1 : 1));
    case LengthMode::min: return std::max(length, value);
    case LengthMode::max: return std::min(length, value);
  }
  assert(false);
  return length;
}

}  // namespace

Evaluation run(const Length& command, const Surface& surface, const FieldSet& fields, const ToolExtras& extras) {
  const bool is_factor = command.mode == LengthMode::scale || command.mode == LengthMode::jitter;
  const double value = is_factor ? command.value : internal_length(command.value, command.units, surface.mesh());
  const std::vector<VertexWeight> region = region_of(command.stroke, command.brush, surface, fields, extras);
  const double mean = command.mode == LengthMode::average ? weighted_mean(region, fields) : 0;
  FieldWriter writer(fields, Field::length);
  Evaluation done;
  for (const auto [v, weight] : region) {
    const double now = fields.length()[v];
    const double goal = goal_of(command, now, value, mean, surface.mesh().positions[v]);
    done.clamped += writer.put(v, now + weight * (goal - now));
  }
  writer.finish(done.delta);
  return done;
}

}  // namespace pelage
