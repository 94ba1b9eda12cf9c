#include "server/surface/value_noise.h"

#include "base/random.h"

namespace pelage {

namespace {

double value_of_bits(std::uint64_t bits) { return static_cast<double>(bits >> 11) * 0x1p-52 - 1; }

std::uint64_t mixed(std::uint64_t bits, std::int64_t coordinate) {
  return mix_bits(bits ^ static_cast<std::uint64_t>(coordinate));
}

}  // namespace

ValueNoise::ValueNoise(glm::dvec3 position) : cell_(glm::floor(position)) {
  const glm::dvec3 part = position - glm::floor(position);
  const glm::dvec3 blend = part * part * (3.0 - 2.0 * part);
  const double share_x[] = {1 - blend.x, blend.x}, share_y[] = {1 - blend.y, blend.y},
               share_z[] = {1 - blend.z, blend.z};
  for (std::size_t corner = 0; corner < 8; ++corner)
    shares_[corner] = share_x[corner & 1] * share_y[(corner >> 1) & 1] * share_z[corner >> 2];
}

double ValueNoise::operator()(std::uint64_t seed) const {
  const std::uint64_t along_x[] = {mixed(seed, cell_.x), mixed(seed, cell_.x + 1)};
  const std::uint64_t along_y[] = {mixed(along_x[0], cell_.y), mixed(along_x[1], cell_.y),
                                   mixed(along_x[0], cell_.y + 1), mixed(along_x[1], cell_.y + 1)};
  double sum = 0;
  for (std::size_t corner = 0; corner < 8; ++corner)
    sum +=
        shares_[corner] * value_of_bits(mixed(along_y[corner & 3], cell_.z + static_cast<std::int64_t>(corner >> 2)));
  return sum;
}

double value_noise(glm::dvec3 position, std::uint64_t seed) { return ValueNoise(position)(seed); }

}  // namespace pelage
