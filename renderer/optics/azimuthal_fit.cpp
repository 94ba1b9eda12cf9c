#include "renderer/optics/azimuthal_fit.h"

#include <array>
#include <bit>
#include <cstddef>
#include <glm/glm.hpp>

namespace pelage {

namespace {

/// The nearest bfloat16.
std::uint32_t bfloat(double value) {
  const auto bits = std::bit_cast<std::uint32_t>(static_cast<float>(value));
  return (bits + 0x7fff + (bits >> 16 & 1)) >> 16;
}

std::int32_t pair_of(double low, double high) { return static_cast<std::int32_t>(bfloat(low) | bfloat(high) << 16); }

/// The sums of t^(i + j + 2) over the table's absorptions: least squares for t, t^2 and t^3 solves by them.
glm::dmat3 moments(int absorptions) {
  glm::dmat3 sums(0);
  for (int k = 0; k < absorptions; ++k) {
    const double t = static_cast<double>(k) / (absorptions - 1);
    const glm::dvec3 powers(t, t * t, t * t * t);
    sums += glm::outerProduct(powers, powers);
  }
  return sums;
}

}  // namespace

AzimuthalFit fit_azimuthal(const ScatteringTable& table) {
  AzimuthalFit fit{table.azimuths, table.inclinations, {}};
  if (table.empty()) return fit;
  const glm::dmat3 solve = glm::inverse(moments(table.absorptions));
  const auto plane = static_cast<std::size_t>(table.azimuths) * static_cast<std::size_t>(table.inclinations);
  for (std::size_t node = 0; node < plane; ++node) {
    const auto value = [&](int k, std::size_t lobe) {
      return double{table.values[4 * (static_cast<std::size_t>(k) * plane + node) + lobe]};
    };
    std::array<glm::dvec3, 4> c{};
    for (std::size_t lobe = 1; lobe < 4; ++lobe) {
      for (int k = 0; k < table.absorptions; ++k) {
        const double t = static_cast<double>(k) / (table.absorptions - 1);
        c[lobe] += value(k, lobe) * glm::dvec3(t, t * t, t * t * t);
      }
      c[lobe] = solve * c[lobe];
    }
    for (const std::int32_t word : {pair_of(value(0, 0), c[1][0]), pair_of(c[1][1], c[1][2]), pair_of(c[2][0], c[2][1]),
                                    pair_of(c[2][2], c[3][0]), pair_of(c[3][1], c[3][2])})
      fit.nodes.push_back(word);
  }
  fit.nodes.insert(fit.nodes.end(), AzimuthalFit::beyond, 0);
  return fit;
}

}  // namespace pelage
