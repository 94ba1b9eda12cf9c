#include "server/surface/value_noise.h"

#include "protocol/base/random.h"

namespace pelage {

namespace {

double lattice_value(glm::i64vec3 cell, std::uint64_t seed) {
  std::uint64_t bits = seed;
  for (int k = 0; k < 3; ++k) bits = mix_bits(bits ^ static_cast<std::uint64_t>(cell[k]));
  return static_cast<double>(bits >> 11) * 0x1p-52 - 1;
}

}  // namespace

double value_noise(glm::dvec3 place, std::uint64_t seed) {
  const glm::dvec3 low = glm::floor(place), part = place - low;
  const glm::dvec3 blend = part * part * (3.0 - 2.0 * part);
  const glm::i64vec3 cell(low);
  double sum = 0;
  for (int corner = 0; corner < 8; ++corner) {
    const glm::i64vec3 step(corner & 1, (corner >> 1) & 1, corner >> 2);
    double share = 1;
    for (int k = 0; k < 3; ++k) share *= step[k] ? blend[k] : 1 - blend[k];
    sum += share * lattice_value(cell + step, seed);
  }
  return sum;
}

}  // namespace pelage
