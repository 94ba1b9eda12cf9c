#include "renderer/shading/scattering_block.h"

#include <cmath>
#include <numbers>

#include "renderer/shading/fibre.h"
#include "renderer/shading/marschner.h"
#include "renderer/shading/scattering_table.h"

namespace pelage {

namespace {

void fill_energy_conserving(const FibreLobes& lobes, ScatteringBlock& block) {
  for (std::size_t p = 0; p < lobe_count; ++p) {
    const auto i = static_cast<glm::length_t>(p);
    const double v = lobes.variance[p];
    block.tilt_sine[i] = static_cast<float>(std::sin(lobes.tilt[p]));
    block.tilt_cosine[i] = static_cast<float>(std::cos(lobes.tilt[p]));
    block.variance[i] = static_cast<float>(v);
    block.normaliser[i] = static_cast<float>(1 / (-v * std::expm1(-2 / v)));
  }
}

void fill_marschner(const MarschnerLobes& lobes, ScatteringBlock& block) {
  for (std::size_t p = 0; p + 1 < lobe_count; ++p) {
    const auto i = static_cast<glm::length_t>(p);
    const double width = lobes.width[p];
    block.centre[i] = static_cast<float>(lobes.centre[p]);
    block.variance[i] = static_cast<float>(width * width);
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
  block.variance = glm::vec4(1);
  if (look.shading == ShadingModel::energy_conserving) fill_energy_conserving(energy_conserving_lobes(fibre), block);
  if (look.shading == ShadingModel::marschner) fill_marschner(marschner_lobes(fibre), block);
  return block;
}

}  // namespace pelage
