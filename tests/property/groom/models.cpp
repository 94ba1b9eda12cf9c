#include "tests/property/groom/models.h"

#include <cstdlib>
#include <utility>

#include "server/builtin/builtin.h"
#include "server/surface/prepare.h"

namespace pelage::testing_models {

namespace {

glm::dvec3 in_cube(Random& random) {
  const double x = random.uniform(-1, 1), y = random.uniform(-1, 1), z = random.uniform(-1, 1);
  return {x, y, z};
}

int whole(Random& random, int low, int high) { return static_cast<int>(random.uniform(low, high + 1)); }

void add_triangle(RawModel& raw, Random& random, glm::dvec3 middle, double size) {
  for (int k = 0; k < 3; ++k) {
    raw.corners.push_back(static_cast<std::uint32_t>(raw.positions.size()));
    raw.positions.push_back(middle + size * in_cube(random));
  }
  raw.face_sizes.push_back(3);
}

}  // namespace

RawModel dented_builtin(Random& random) {
  constexpr Builtin kinds[] = {Builtin::sphere, Builtin::torus, Builtin::plane, Builtin::knot, Builtin::sphere};
  RawModel raw = make_builtin({kinds[whole(random, 0, 4)], whole(random, 20, 400)});
  for (glm::dvec3& position : raw.positions) position += 0.01 * in_cube(random);
  return raw;
}

RawModel lone_triangle(Random& random) {
  RawModel raw;
  add_triangle(raw, random, in_cube(random), 1);
  return raw;
}

RawModel soup(Random& random) {
  RawModel raw;
  for (int k = whole(random, 1, 30); k > 0; --k) add_triangle(raw, random, in_cube(random), 0.4);
  return raw;
}

RawModel many_parts(Random& random) {
  RawModel raw;
  for (int part = whole(random, 2, 4); part > 0; --part) {
    RawModel ball = make_builtin({Builtin::sphere, whole(random, 20, 120)});
    const glm::dvec3 centre = 3.0 * in_cube(random);
    const auto first = static_cast<std::uint32_t>(raw.positions.size());
    for (const glm::dvec3 position : ball.positions)
      raw.positions.push_back(centre + position + 0.01 * in_cube(random));
    for (const std::uint32_t corner : ball.corners) raw.corners.push_back(first + corner);
    raw.face_sizes.insert(raw.face_sizes.end(), ball.face_sizes.begin(), ball.face_sizes.end());
  }
  return raw;
}

RawModel any_model(Random& random) {
  const double kind = random.uniform();
  if (kind < 0.1) return lone_triangle(random);
  if (kind < 0.2) return soup(random);
  return kind < 0.4 ? many_parts(random) : dented_builtin(random);
}

Surface surface_of(const RawModel& raw) {
  Result<Mesh> mesh = prepare(raw);
  if (!mesh.ok()) std::abort();
  return Surface(std::move(*mesh));
}

}  // namespace pelage::testing_models
