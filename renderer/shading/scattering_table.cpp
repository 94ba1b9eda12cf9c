#include "renderer/shading/scattering_table.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <numbers>

#include "base/parallel.h"
#include "renderer/shaders/constants.h"
#include "renderer/shading/fibre.h"
#include "renderer/shading/marschner.h"

namespace pelage {

static_assert(static_cast<int>(ShadingModel::lengyel) == model_lengyel);
static_assert(static_cast<int>(ShadingModel::kajiya) == model_kajiya);
static_assert(static_cast<int>(ShadingModel::energy_conserving) == model_energy_conserving);
static_assert(static_cast<int>(ShadingModel::scheuermann) == model_scheuermann);
static_assert(static_cast<int>(ShadingModel::kajiya_kay) == model_kajiya_kay);
static_assert(static_cast<int>(ShadingModel::marschner) == model_marschner);

namespace {

constexpr int azimuth_nodes = 128, inclination_nodes = 32, absorption_nodes = 32;
constexpr double opaque = 1e4;  // sigma_a for the coordinate 0

double fraction(int i, int count) { return double(i) / (count - 1); }

double absorption_at(double coordinate) {
  const double root = std::log(coordinate) / 3;
  return coordinate > 0 ? root * root : opaque;
}

double azimuth_at(double coordinate) {
  const double along = 1 - 2 * coordinate;
  return std::atan2(1 - std::abs(along), along);
}

/// Fills all azimuths and absorptions of one inclination.
void fill_inclination(const AzimuthalAverage& average, int j, ScatteringTable& table) {
  const double cos_theta = fraction(j, table.inclinations);
  const AzimuthalAverage::NodeValues exits = average.exits(cos_theta);
  std::vector<AzimuthalAverage::NodeValues> passed;
  for (int k = 0; k < table.absorptions; ++k) {
    passed.push_back(average.passed(cos_theta, absorption_at(fraction(k, table.absorptions))));
  }
  for (int i = 0; i < table.azimuths; ++i) {
    const double azimuth = azimuth_at(fraction(i, table.azimuths));
    const AzimuthalAverage::NodeValues spread = average.spread(exits, azimuth);
    for (int k = 0; k < table.absorptions; ++k) {
      const LobeValues lobes = average.sum(spread, passed[static_cast<std::size_t>(k)], cos_theta, azimuth);
      const int texel = (k * table.inclinations + j) * table.azimuths + i;
      std::copy(lobes.begin(), lobes.end(), table.values.begin() + 4 * texel);
    }
  }
}

}  // namespace

double azimuth_coordinate(double azimuth) {
  const double along = std::cos(azimuth), across = std::abs(std::sin(azimuth));
  return 0.5 - 0.5 * along / (std::abs(along) + across);
}

double absorption_coordinate(double sigma_a) { return std::exp(-3 * std::sqrt(sigma_a)); }

ScatteringTable make_scattering_table(const Look& look) {
  if (look.shading != ShadingModel::energy_conserving && look.shading != ShadingModel::marschner) return {};
  ScatteringTable table{azimuth_nodes, inclination_nodes, absorption_nodes, {}};
  table.values.resize(std::size_t{4} * azimuth_nodes * inclination_nodes * absorption_nodes);
  const AzimuthalAverage average(look.shading, look.fibre);
  for_each_in_parallel(static_cast<std::uint32_t>(table.inclinations),
                       [&](std::uint32_t j) { fill_inclination(average, static_cast<int>(j), table); });
  return table;
}

namespace {

void fill_energy_conserving(const FibreLobes& lobes, ScatteringBlock& block) {
  for (std::size_t p = 0; p < lobe_count; ++p) {
    const auto i = static_cast<glm::length_t>(p);
    const double v = lobes.variance[p];
    block.tilt_sine[i] = static_cast<float>(std::sin(lobes.tilt[p]));
    block.tilt_cosine[i] = static_cast<float>(std::cos(lobes.tilt[p]));
    block.over_variance[i] = static_cast<float>(1 / v);
    block.normaliser[i] = static_cast<float>(1 / (-v * std::expm1(-2 / v)));
  }
}

void fill_marschner(const MarschnerLobes& lobes, ScatteringBlock& block) {
  for (std::size_t p = 0; p + 1 < lobe_count; ++p) {
    const auto i = static_cast<glm::length_t>(p);
    const double width = lobes.width[p];
    block.centre[i] = static_cast<float>(lobes.centre[p]);
    block.over_variance[i] = static_cast<float>(1 / (width * width));
    block.normaliser[i] = static_cast<float>(1 / (2 * width * std::sqrt(2 * std::numbers::pi)));
  }
}

glm::vec4 given_absorption(const FibreOptics& fibre) {
  const glm::dvec3 sigma_a = absorption_from_melanin(fibre.eumelanin, fibre.pheomelanin);
  return {absorption_coordinate(sigma_a.r), absorption_coordinate(sigma_a.g), absorption_coordinate(sigma_a.b), 0};
}

}  // namespace

ScatteringBlock scattering_block(const Look& look) {
  const FibreOptics& fibre = look.fibre;
  ScatteringBlock block{};
  block.model = {static_cast<int>(look.shading), fibre.absorption == Absorption::melanin, 0, 0};
  block.weights = glm::vec4(look.diffuse, look.specular, fibre.secondary_specular, fibre.shift_spread);
  block.exponents = glm::vec4(look.diffuse_exponent, look.specular_exponent, fibre.secondary_exponent,
                              3 / colour_polynomial(fibre.azimuthal_roughness));
  block.shifts = glm::vec4(fibre.primary_shift, fibre.secondary_shift, 0, 0);
  block.absorption = given_absorption(fibre);
  block.over_variance = glm::vec4(1);
  if (look.shading == ShadingModel::energy_conserving) fill_energy_conserving(energy_conserving_lobes(fibre), block);
  if (look.shading == ShadingModel::marschner) fill_marschner(marschner_lobes(fibre), block);
  return block;
}

}  // namespace pelage
