#include "renderer/optics/azimuthal_fit.h"

#include <Eigen/Dense>
#include <array>
#include <bit>
#include <cstddef>

namespace pelage {

namespace {

/// The nearest bfloat16.
std::uint32_t bfloat(double value) {
  const auto bits = std::bit_cast<std::uint32_t>(static_cast<float>(value));
  return (bits + 0x7fff + (bits >> 16 & 1)) >> 16;
}

std::int32_t pair_of(double low, double high) { return static_cast<std::int32_t>(bfloat(low) | bfloat(high) << 16); }

/// From values at the table's absorptions to the three factors.
Eigen::MatrixXd least_squares(int absorptions) {
  Eigen::MatrixXd powers(absorptions, 3);
  for (int k = 0; k < absorptions; ++k) {
    const double t = static_cast<double>(k) / (absorptions - 1);
    powers.row(k) << t, t * t, t * t * t;
  }
  return (powers.transpose() * powers).ldlt().solve(powers.transpose());
}

}  // namespace

AzimuthalFit fit_azimuthal(const ScatteringTable& table) {
  AzimuthalFit fit{table.azimuths, table.inclinations, {}};
  if (table.empty()) return fit;
  const Eigen::MatrixXd solve = least_squares(table.absorptions);
  const auto plane = static_cast<std::size_t>(table.azimuths) * static_cast<std::size_t>(table.inclinations);
  for (std::size_t node = 0; node < plane; ++node) {
    const auto value = [&](int k, std::size_t lobe) {
      return table.values[4 * (static_cast<std::size_t>(k) * plane + node) + lobe];
    };
    std::array<Eigen::Vector3d, 4> c;
    for (std::size_t lobe = 1; lobe < 4; ++lobe) {
      Eigen::VectorXd values(table.absorptions);
      for (int k = 0; k < table.absorptions; ++k) values[k] = value(k, lobe);
      c[lobe] = solve * values;
    }
    for (const std::int32_t word : {pair_of(value(0, 0), c[1][0]), pair_of(c[1][1], c[1][2]), pair_of(c[2][0], c[2][1]),
                                    pair_of(c[2][2], c[3][0]), pair_of(c[3][1], c[3][2])})
      fit.nodes.push_back(word);
  }
  return fit;
}

}  // namespace pelage
