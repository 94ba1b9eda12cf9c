// Light on a strand in SIMD lanes against the formulas in double (tests/double_shading). The rasterizer and the strand
// tracer use this code.
#include "renderer/optics/one_strand.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>

#include "tests/double_shading/fibre_shading.h"

namespace pelage {
namespace {

constexpr ShadingModel all_models[] = {ShadingModel::lengyel,           ShadingModel::kajiya,
                                       ShadingModel::energy_conserving, ShadingModel::scheuermann,
                                       ShadingModel::kajiya_kay,        ShadingModel::marschner};

bool is_fibre_model(ShadingModel model) {
  return model == ShadingModel::energy_conserving || model == ShadingModel::marschner;
}

StrandOptics optics_of(const Look& look) {
  return {scattering_block(look), fit_azimuthal(make_scattering_table(look)), static_cast<int>(look.shading),
          static_cast<float>(look.back_attenuation), 0};
}

Look look_of(ShadingModel model) {
  Look look;
  look.shading = model;
  return look;
}

class Cases {
 public:
  LitStrand next() {
    return {direction(), direction(), direction(), direction(), {number(), number(), number()}, number(), 0};
  }

 private:
  float number() { return static_cast<float>(random_() / 4294967296.0); }
  glm::vec3 direction() {
    const float z = 2 * number() - 1, turn = 6.2831853f * number(), r = std::sqrt(1 - z * z);
    return {r * std::cos(turn), r * std::sin(turn), z};
  }
  std::mt19937 random_{7};
};

ScatterGeometry geometry_of(const LitStrand& strand) {
  const auto unit = [](const glm::vec3& v) { return glm::normalize(glm::dvec3(v)); };
  return {unit(strand.tangent), unit(strand.normal), unit(strand.to_light), unit(strand.to_camera)};
}

/// The models of science.md 4, with what a bundle adds to a fibre (scatter_again of lighting.glsl) and B.
glm::dvec3 expected(const Look& look, const FibreShading& shading, const LitStrand& strand) {
  const ScatterGeometry geometry = geometry_of(strand);
  glm::dvec3 light = shading.scatter(geometry, glm::dvec3(strand.colour), double(strand.number));
  if (is_fibre_model(look.shading)) {
    const double along = glm::dot(geometry.tangent, geometry.to_light);
    light = 0.6 * light + 0.55 * look.diffuse * std::sqrt(1 - along * along) * glm::dvec3(strand.colour);
  }
  return light * backlight_fade(look.shading, glm::dot(geometry.normal, geometry.to_light), look.back_attenuation);
}

struct Difference {
  double largest = 0, mean = 0;  // relative to the largest and to the mean value
};

Difference difference_of(const Look& look) {
  const FibreShading shading(look);
  const StrandOptics optics = optics_of(look);
  Cases cases;
  constexpr int count = 2000;
  double largest = 0, sum = 0, largest_value = 0, value_sum = 0;
  for (int i = 0; i < count; ++i) {
    const LitStrand strand = cases.next();
    const glm::dvec3 truth = expected(look, shading, strand), found(scatter_strand(optics, strand));
    for (int k = 0; k < 3; ++k) {
      largest = std::max(largest, std::abs(found[k] - truth[k])), sum += std::abs(found[k] - truth[k]);
      largest_value = std::max(largest_value, truth[k]), value_sum += truth[k];
    }
  }
  return {largest / largest_value, sum / value_sum};
}

/// Formulas without a table: only the lanes' exp and log differ.
TEST(OneStrand, FormulasAgreeWithDouble) {
  for (const ShadingModel model : all_models) {
    if (is_fibre_model(model)) continue;
    EXPECT_LT(difference_of(look_of(model)).largest, 1e-5) << "model " << int(model);
  }
}

/// Fibre models read a fit of the azimuthal table (AzimuthalFit), which is less exact.
TEST(OneStrand, FibresAgreeWithDouble) {
  for (const ShadingModel model : {ShadingModel::energy_conserving, ShadingModel::marschner}) {
    const Difference apart = difference_of(look_of(model));
    EXPECT_LT(apart.mean, 0.008) << "model " << int(model);
    EXPECT_LT(apart.largest, 0.04) << "model " << int(model);
  }
}

TEST(OneStrand, BundleIsAFibreAndWhatFollows) {
  for (const ShadingModel model : {ShadingModel::energy_conserving, ShadingModel::marschner}) {
    const StrandOptics optics = optics_of(look_of(model));
    Cases cases;
    for (int i = 0; i < 100; ++i) {
      const LitStrand strand = cases.next();
      const glm::vec3 whole = scatter_strand(optics, strand);
      const glm::vec3 parts = scatter_bundle(optics, strand, scatter_once(optics, strand));
      for (int k = 0; k < 3; ++k) EXPECT_NEAR(whole[k], parts[k], 1e-6f * (1 + whole[k]));
    }
  }
}

/// Painted water narrows and brightens the highlight of a surface model as `wet_look` does for a whole coat.
TEST(OneStrand, PaintedWaterRaisesTheHighlight) {
  Look look = look_of(ShadingModel::kajiya);
  look.diffuse = 0;
  const StrandOptics optics = optics_of(look);
  LitStrand strand{{1, 0, 0}, {0, 1, 0}, {0, 1, 0}, {0, 1, 0}, glm::vec3(0.5f), 0.5f, 0};
  const float dry = scatter_strand(optics, strand).r;
  strand.wetness = 1;
  EXPECT_GT(scatter_strand(optics, strand).r, 1.2f * dry);
}

std::vector<LitStrand> extreme_strands() {
  const glm::vec3 x(1, 0, 0), y(0, 1, 0), slanted = glm::normalize(glm::vec3(1, 2, -0.5));
  const glm::vec3 grazing = glm::normalize(glm::vec3(1, 1e-4, 0));
  std::vector<LitStrand> made;
  for (const glm::vec3& light : {x, -x, y, slanted, -slanted, grazing}) {
    for (const glm::vec3& eye : {x, -x, y, slanted, grazing}) {
      for (const float colour : {0.0f, 1.0f}) made.push_back({x, y, eye, light, glm::vec3(colour), 1, 1});
    }
  }
  return made;
}

TEST(OneStrand, ExtremesAreFinite) {
  for (const ShadingModel model : all_models) {
    for (const double roughness : {0.0, 1e-4, 1.0}) {
      for (const double exponent : {0.0, 1e6}) {
        Look look = look_of(model);
        look.fibre.longitudinal_roughness = look.fibre.azimuthal_roughness = roughness;
        look.diffuse_exponent = look.specular_exponent = look.fibre.secondary_exponent = exponent;
        const StrandOptics optics = optics_of(look);
        for (const LitStrand& strand : extreme_strands()) {
          const glm::vec3 light = scatter_strand(optics, strand);
          for (int k = 0; k < 3; ++k) EXPECT_TRUE(std::isfinite(light[k]) && light[k] >= 0) << int(model);
        }
      }
    }
  }
}

}  // namespace
}  // namespace pelage
