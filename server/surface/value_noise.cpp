#include "server/surface/value_noise.h"

#include "protocol/base/random.h"

namespace pelage {

namespace {

double value_of_bits(std::uint64_t bits) { return static_cast<double>(bits >> 11) * 0x1p-52 - 1; }

std::uint64_t mixed(std::uint64_t bits, std::int64_t coordinate) {
  return mix_bits(bits ^ static_cast<std::uint64_t>(coordinate));
}

}  // namespace

double value_noise(glm::dvec3 place, std::uint64_t seed) {
  const glm::dvec3 low = glm::floor(place), part = place - low;
  const glm::dvec3 blend = part * part * (3.0 - 2.0 * part);
  const glm::i64vec3 cell(low);
  const std::uint64_t along_x[] = {mixed(seed, cell.x), mixed(seed, cell.x + 1)};
  const std::uint64_t along_y[] = {mixed(along_x[0], cell.y), mixed(along_x[1], cell.y), mixed(along_x[0], cell.y + 1),
                                   mixed(along_x[1], cell.y + 1)};
  const double share_x[] = {1 - blend.x, blend.x}, share_y[] = {1 - blend.y, blend.y}, share_z[] = {1 - blend.z, blend.z};
  double sum = 0;
  for (int corner = 0; corner < 8; ++corner) {
    const double share = share_x[corner & 1] * share_y[(corner >> 1) & 1] * share_z[corner >> 2];
    sum += share * value_of_bits(mixed(along_y[corner & 3], cell.z + (corner >> 2)));
  }
  return sum;
}

}  // namespace pelage
