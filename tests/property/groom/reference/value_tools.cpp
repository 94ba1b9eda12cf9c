// Tools that change values vertex by vertex.
#include <algorithm>
#include <bit>
#include <cmath>

#include "base/random.h"
#include "tests/property/groom/reference/brush.h"
#include "tests/property/groom/reference/tools.h"

namespace pelage::plain {

namespace {

/// A random number in [-1, 1], hashed from a position's 32-bit coordinates.
double number_at(glm::vec3 p, std::uint64_t seed) {
  std::uint64_t bits[3];
  for (int k = 0; k < 3; ++k) bits[k] = std::bit_cast<std::uint32_t>(p[k] == 0 ? 0.0f : p[k]);
  return 2 * Random(seed, mix_bits((bits[0] << 32) + bits[1]) ^ bits[2]).uniform() - 1;
}

/// Random values of the eight lattice points around, blended by smoothsteps.
double lattice_noise(dvec3 p, std::uint64_t seed) {
  double sum = 0;
  for (int x = 0; x < 2; ++x) {
    for (int y = 0; y < 2; ++y) {
      for (int z = 0; z < 2; ++z) {
        std::uint64_t bits = seed;
        double share = 1;
        const int corner[3] = {x, y, z};
        for (int k = 0; k < 3; ++k) {
          const double cell = std::floor(p[k]) + corner[k], near = 1 - std::abs(p[k] - cell);
          bits = mix_bits(bits ^ static_cast<std::uint64_t>(static_cast<std::int64_t>(cell)));
          share *= near * near * (3 - 2 * near);
        }
        sum += share * (2 * (static_cast<double>(bits >> 11) / 9007199254740992.0) - 1);
      }
    }
  }
  return sum;
}

double noise_at(const Noise& command, const Body& body, Vertex v, std::size_t channel) {
  const std::uint64_t seed = mix_bits(command.seed ^ (static_cast<std::uint64_t>(channel) << 32));
  const double feature = body.sizes(command.feature_size, command.units);
  return feature < 1e-8 ? number_at(glm::vec3(body.positions[v]), seed)
                        : lattice_noise(body.positions[v] / feature, seed);
}

void disturb(const Noise& command, const Body& body, Field field, double amount, Vertex v, dvec4& value) {
  if (field == Field::direction) {
    dvec3 random;
    for (std::size_t k = 0; k < 3; ++k) random[static_cast<int>(k)] = noise_at(command, body, v, k);
    value += dvec4(amount * body.in_frame(v, random), 0, 0);
    return;
  }
  const bool share =
      field == Field::length || field == Field::stretch || field == Field::width || field == Field::stiffness;
  for (int c = 0; c < shape_of(field).channels; ++c) {
    const std::size_t channel = 8 * static_cast<std::size_t>(field) + static_cast<std::size_t>(c);
    value[c] += amount * noise_at(command, body, v, channel) * (share ? value[c] : 1);
  }
}

/// Tells whether fur may be at a position. `root` and `position` are in internal coordinates, `up` is the height over
/// the skin.
class Allowed {
 public:
  Allowed(const Trim& command, const Body& body) : command_(command), body_(body) {}

  bool root(dvec3 root) const { return std::holds_alternative<double>(command_.shape) || beyond(root, 0) < 0; }

  /// How far a position is beyond the shape; 0 on its border, negative inside.
  double beyond(dvec3 position, double up) const {
    if (const auto* plane = std::get_if<TrimPlane>(&command_.shape))
      return glm::dot(position - body_.inside(plane->point), unit(plane->normal));
    if (const auto* sphere = std::get_if<TrimSphere>(&command_.shape)) {
      const double out =
          glm::distance(position, body_.inside(sphere->centre)) - body_.sizes(sphere->radius, command_.units);
      return sphere->keep_inside ? out : -out;
    }
    return up - body_.sizes(std::get<double>(command_.shape), command_.units);
  }

 private:
  const Trim& command_;
  const Body& body_;
};

/// The largest length up to `now` at which the tip, `offset` for a strand of length 1, is not beyond the shape and has
/// not passed through it. Searches in even steps, then by halving.
double longest(const Allowed& allowed, dvec3 root, dvec3 offset, double up, double now) {
  constexpr int steps = 2000;
  for (int k = 1; k <= steps; ++k) {
    double high = now * k / steps, low = now * (k - 1) / steps;
    if (allowed.beyond(root + high * offset, high * up) <= 0) continue;
    for (int halving = 0; halving < 60; ++halving) {
      const double middle = (low + high) / 2;
      (allowed.beyond(root + middle * offset, middle * up) <= 0 ? low : high) = middle;
    }
    return low;
  }
  return now;
}

double jitter(const Length& command, const Body& body, Vertex v) {
  return command.value * number_at(glm::vec3(body.positions[v]), command.seed) * (command.brush.invert ? -1 : 1);
}

}  // namespace

void apply(const Noise& command, const Stage& stage, Fur& fur) {
  const std::vector<double> region = region_of(command.stroke, command.brush, stage, fur);
  for (const Field field : command.fields) {
    for (Vertex v = 0; v < stage.body.size(); ++v)
      disturb(command, stage.body, field,
              (command.brush.invert ? -1 : 1) * command.amount * region[v] * strand_part(command.brush, field), v,
              fur.of(field)[v]);
  }
}

void apply(const Unify& command, const Stage& stage, Fur& fur) {
  const Body& body = stage.body;
  const std::vector<double> region = region_of(command.stroke, command.brush, stage, fur);
  double whole = 0, inclination = 0;
  dvec3 lean(0);
  fur.multiply_colours();
  Fur mean = fur;  // vertex 0 holds the means
  for (std::vector<dvec4>& values : mean.values) values[0] = dvec4(0);
  for (Vertex v = 0; v < body.size(); ++v) whole += region[v];
  if (whole == 0) return fur.divide_colours();
  for (Vertex v = 0; v < body.size(); ++v) {
    const double share = region[v] / whole;
    inclination += share * glm::length(fur.direction(v));
    lean += share * body.in_space(v, fur.direction(v));
    for (std::size_t f = 0; f < field_count; ++f) mean.values[f][0] += share * fur.values[f][v];
  }
  const auto named = [&](Field field) {
    return std::find(command.mean.begin(), command.mean.end(), field) != command.mean.end();
  };
  const bool given = command.direction || command.inclination;
  for (Vertex v = 0; v < body.size(); ++v) {
    const double w = command.weight * region[v];
    const dvec2 now = fur.direction(v);
    const double own = glm::length(now);
    if (given && command.direction)
      fur.of(Field::direction)[v] =
          dvec4(turned_to(body, v, now, unit(*command.direction), command.inclination.value_or(own), w), 0, 0);
    else if (given && own > 1e-6)
      fur.of(Field::direction)[v] = dvec4(now / own * ((1 - w) * own + w * *command.inclination), 0, 0);
    else if (!given && named(Field::direction))
      fur.of(Field::direction)[v] = dvec4(turned_to(body, v, now, unit(lean), inclination, w), 0, 0);
    if (command.length) mean.of(Field::length)[0] = dvec4(body.sizes(*command.length, command.units), 0, 0, 0);
    for (std::size_t f = 1; f < field_count; ++f) {
      const double part = w * strand_part(command.brush, field_at(f));
      if (named(field_at(f)) || (field_at(f) == Field::length && command.length))
        fur.values[f][v] = (1 - part) * fur.values[f][v] + part * mean.values[f][0];
    }
  }
  fur.divide_colours();
}

void apply(const Length& command, const Stage& stage, Fur& fur) {
  const Body& body = stage.body;
  const std::vector<double> region = region_of(command.stroke, command.brush, stage, fur);
  const double value = body.sizes(command.value, command.units);
  double sum = 0, whole = 0;
  for (Vertex v = 0; v < body.size(); ++v) sum += region[v] * fur.number(Field::length, v), whole += region[v];
  for (Vertex v = 0; v < body.size(); ++v) {
    double& length = fur.of(Field::length)[v].x;
    double goal = length;
    if (command.mode == LengthMode::set) goal = value;
    if (command.mode == LengthMode::add) goal = length + (command.brush.invert ? -value : value);
    if (command.mode == LengthMode::scale && !command.brush.invert) goal = length * command.value;
    if (command.mode == LengthMode::scale && command.brush.invert && command.value > 0) goal = length / command.value;
    if (command.mode == LengthMode::average && whole > 0) goal = sum / whole;
    if (command.mode == LengthMode::jitter) goal = length * (1 + jitter(command, body, v));
    if (command.mode == LengthMode::min) goal = std::max(length, value);
    if (command.mode == LengthMode::max) goal = std::min(length, value);
    length = (1 - region[v]) * length + region[v] * goal;
  }
}

void apply(const Trim& command, const Stage& stage, Fur& fur) {
  const Body& body = stage.body;
  const Allowed allowed(command, body);
  const std::vector<double> region = restriction_of(command.stroke, command.brush, stage, fur);
  for (Vertex v = 0; v < body.size(); ++v) {
    if (region[v] == 0) continue;
    double& length = fur.of(Field::length)[v].x;
    double cut = allowed.root(body.positions[v]) ? length : 0;
    const double inclination = std::min(1.0, glm::length(fur.direction(v)));
    const dvec3 sideways = unit(body.in_space(v, fur.direction(v)));
    for (int k = 1; k <= 8; ++k) {
      const dvec2 position = lean_position(stage.coat, inclination, k / 8.0);
      cut = std::min(cut, longest(allowed, body.positions[v], position.x * sideways + position.y * body.normals[v],
                                  position.y, cut));
    }
    length += region[v] * (cut - length);
  }
}

void apply(const Erase& command, const Stage& stage, Fur& fur) {
  const std::vector<double> region = region_of(command.stroke, command.brush, stage, fur);
  Fur baseline = stage.baseline;
  baseline.multiply_colours(), fur.multiply_colours();
  for (std::size_t f = 0; f < field_count; ++f) {
    const Field field = field_at(f);
    const bool named = std::find(command.fields.begin(), command.fields.end(), field) != command.fields.end();
    if (!named && !(command.fields.empty() && field != Field::mask)) continue;
    const double part = strand_part(command.brush, field);
    for (Vertex v = 0; v < stage.body.size(); ++v)
      fur.of(field)[v] = (1 - part * region[v]) * fur.of(field)[v] + part * region[v] * baseline.of(field)[v];
  }
  fur.divide_colours();
}

void apply(const Paint& command, const Stage& stage, Fur& fur) {
  const std::vector<double> region = region_of(command.stroke, command.brush, stage, fur, command.field != Field::mask);
  const double value = command.brush.invert ? double{shape_of(command.field).default_value} : command.value;
  for (Vertex v = 0; v < stage.body.size(); ++v) {
    dvec4& now = fur.of(command.field)[v];
    const double w = region[v] * strand_part(command.brush, command.field);
    if (shape_of(command.field).channels == 1) {
      now.x = (1 - w) * now.x + w * value;
      continue;
    }
    if (region[v] == 0) continue;
    // Colours are weighted by their coverage.
    const dvec4 below((1 - w) * now.w * dvec3(now), (1 - w) * now.w);
    const dvec4 laid(w * value * dvec3(command.colour), w * value);
    const dvec4 both = below + laid;
    now = both.w > 0 ? dvec4(dvec3(both) / both.w, both.w) : dvec4(0);
  }
}

}  // namespace pelage::plain
