// Every shading model in GLSL against C++, on directions, colours and strands of all kinds.
#include <algorithm>
#include <cmath>
#include <random>
#include <vector>

#include "renderer/shading/fibre.h"
#include "renderer/shading/scattering_table.h"
#include "tests/double_shading/fibre_shading.h"
#include "tests/gl/backends.h"
#include "tests/gl/grid.h"

namespace pelage {
namespace shaders {
extern const char* const lean_grid_vert;
extern const char* const scattering_grid_frag;
}  // namespace shaders

namespace testing::scattering_test {
namespace {

constexpr int side = 48, cases = side * side;
constexpr ShadingModel all_models[] = {ShadingModel::lengyel,           ShadingModel::kajiya,
                                       ShadingModel::energy_conserving, ShadingModel::scheuermann,
                                       ShadingModel::kajiya_kay,        ShadingModel::marschner};

/// Inputs of one pixel, in the floats that the shader gets.
struct Case {
  glm::vec3 tangent, normal, to_light, to_camera, colour;
  float strand;

  ScatterGeometry geometry() const {
    const auto unit = [](const glm::vec3& v) { return glm::normalize(glm::dvec3(v)); };
    return {unit(tangent), unit(normal), unit(to_light), unit(to_camera)};
  }
};

std::vector<Case> random_cases() {
  std::mt19937 random(7);
  const auto number = [&] { return static_cast<double>(random()) / 4294967296.0; };
  const auto direction = [&] {
    const double z = 2 * number() - 1, turn = 2 * 3.14159265358979 * number(), r = std::sqrt(1 - z * z);
    return glm::vec3(r * std::cos(turn), r * std::sin(turn), z);
  };
  std::vector<Case> made;
  for (int i = 0; i < cases; ++i) {
    const glm::vec3 colour(number(), number(), number());
    made.push_back({direction(), direction(), direction(), direction(), colour, static_cast<float>(number())});
  }
  return made;
}

/// Directions along, against and across one another, with black and white, repeated.
std::vector<Case> extreme_cases() {
  const glm::vec3 slanted = glm::normalize(glm::vec3(1, 2, -0.5)), x(1, 0, 0), y(0, 1, 0);
  const glm::vec3 grazing = glm::normalize(glm::vec3(1, 1e-4, 0));
  const std::vector<glm::vec3> directions{x, -x, y, -y, slanted, -slanted, grazing};
  std::vector<Case> made;
  for (std::size_t i = 0; made.size() < cases; ++i) {
    const std::size_t n = directions.size();
    const glm::vec3 colour(i % 2 ? 0.0f : 1.0f, 0.5f, i % 3 ? 1.0f : 0.0f);
    made.push_back({directions[i / (n * n) % n], y, directions[i % n], directions[i / n % n], colour, 1});
  }
  return made;
}

class Scattering : public OnBackend {
 protected:
  std::vector<glm::vec4> on_gpu(const Look& look, const std::vector<Case>& asked, const ScatteringTable& table,
                                bool by_lobe = false) {
    const Program program(gl(), shaders::lean_grid_vert, shaders::scattering_grid_frag);
    EXPECT_EQ(program.log(), "");
    const Buffer block = send_block(gl(), 3, scattering_block(look));
    const Texture inputs = send_cases(asked), azimuthal = send_table(table);
    gl().BindTextureUnit(0, inputs.id());
    gl().BindTextureUnit(3, azimuthal.id());
    program.use();
    program.set("by_lobe", by_lobe ? 1 : 0);
    return answers(gl(), side);
  }

 private:
  Texture send_cases(const std::vector<Case>& asked) {
    std::vector<glm::vec4> texels;
    for (const Case& c : asked) texels.emplace_back(c.tangent, 0);
    for (const Case& c : asked) texels.emplace_back(c.normal, 0);
    for (const Case& c : asked) texels.emplace_back(c.to_light, 0);
    for (const Case& c : asked) texels.emplace_back(c.to_camera, 0);
    for (const Case& c : asked) texels.emplace_back(c.colour, c.strand);
    return send_images(gl(), side, texels);
  }

  Texture send_table(const ScatteringTable& table) {
    Texture texture(gl(), GLenum{GL_TEXTURE_3D});
    if (table.empty()) return texture;
    gl().TextureStorage3D(texture.id(), 1, GL_RGBA32F, table.azimuths, table.inclinations, table.absorptions);
    gl().TextureSubImage3D(texture.id(), 0, 0, 0, 0, table.azimuths, table.inclinations, table.absorptions, GL_RGBA,
                           GL_FLOAT, table.values.data());
    gl().TextureParameteri(texture.id(), GL_TEXTURE_MIN_FILTER, GL_LINEAR);
    gl().TextureParameteri(texture.id(), GL_TEXTURE_MAG_FILTER, GL_LINEAR);
    for (const GLenum axis : {GL_TEXTURE_WRAP_S, GL_TEXTURE_WRAP_T, GL_TEXTURE_WRAP_R}) {
      gl().TextureParameteri(texture.id(), axis, GL_CLAMP_TO_EDGE);
    }
    return texture;
  }
};

/// Largest relative difference, over values above a hundredth of the grid's largest.
double largest_difference(const Look& look, const std::vector<Case>& asked, const ScatteringTable& table,
                          const std::vector<glm::vec4>& pixels) {
  const FibreShading shading(look);
  std::vector<glm::dvec3> truth;
  double peak = 0;
  for (const Case& c : asked) {
    truth.push_back(shading.scatter(c.geometry(), glm::dvec3(c.colour), double(c.strand), table));
    peak = std::max({peak, truth.back().r, truth.back().g, truth.back().b});
  }
  double largest = 0;
  for (std::size_t i = 0; i < asked.size(); ++i) {
    for (int channel = 0; channel < 3; ++channel) {
      const double apart = std::abs(double(pixels[i][channel]) - truth[i][channel]);
      largest = std::max(largest, apart / std::max(truth[i][channel], peak / 100));
    }
  }
  return largest;
}

std::vector<Look> looks_of(ShadingModel model) {
  Look plain, sharp, pigmented;
  sharp.specular_exponent = 400;
  sharp.fibre.longitudinal_roughness = 0.1;
  sharp.fibre.azimuthal_roughness = 0.1;
  sharp.fibre.highlight_width = 4;
  sharp.fibre.cuticle_tilt = 7.5;
  pigmented.fibre.absorption = Absorption::melanin;
  pigmented.fibre.pheomelanin = 0.2;
  pigmented.fibre.refractive_index = 1.3;
  pigmented.fibre.longitudinal_roughness = 0.9;
  std::vector<Look> looks{plain, sharp, pigmented};
  for (Look& look : looks) look.shading = model;
  return looks;
}

TEST_P(Scattering, AgreesWithTheCpu) {
  const std::vector<Case> asked = random_cases();
  for (const ShadingModel model : all_models) {
    for (const Look& look : looks_of(model)) {
      const ScatteringTable table = make_scattering_table(look);
      const double largest = largest_difference(look, asked, table, on_gpu(look, asked, table));
      EXPECT_LT(largest, table.empty() ? 1e-3 : 4e-3) << "model " << int(model);  // GPUs filter with 8 bits of weight
    }
  }
}

/// M Ap Np of one fibre, lobe by lobe, for red.
LobeValues lobes_of(const FibreShading& shading, const Look& look, const Case& c, const ScatteringTable& table) {
  const ScatterGeometry geometry = c.geometry();
  const auto inclination = [&](const glm::dvec3& direction) {
    const double sine = std::clamp(-glm::dot(geometry.tangent, direction), -1.0, 1.0);
    return Inclination{sine, std::sqrt(1 - sine * sine)};
  };
  const Inclination light = inclination(geometry.to_light), eye = inclination(geometry.to_camera);
  const bool marschner = look.shading == ShadingModel::marschner;
  const LobeValues m = marschner ? marschner_longitudinal(marschner_lobes(look.fibre), light, eye)
                                 : longitudinal_lobes(energy_conserving_lobes(look.fibre), light, eye);
  const glm::dvec3 across_light = geometry.to_light + geometry.tangent * light.sine;
  const glm::dvec3 across_view = geometry.to_camera + geometry.tangent * eye.sine;
  const double azimuth =
      std::acos(std::clamp(glm::dot(glm::normalize(across_light), glm::normalize(across_view)), -1.0, 1.0));
  const double sigma_a = shading.absorption(glm::dvec3(c.colour)).r;
  LobeValues n =
      table_at(table, marschner ? cos_difference(light, eye) : eye.cosine, azimuth, absorption_coordinate(sigma_a));
  for (std::size_t p = 0; p < lobe_count; ++p) n[p] *= m[p];
  return n;
}

TEST_P(Scattering, EveryLobeOfAFibreAgreesWithTheCpu) {
  const std::vector<Case> asked = random_cases();
  for (const ShadingModel model : {ShadingModel::energy_conserving, ShadingModel::marschner}) {
    for (const Look& look : looks_of(model)) {
      const ScatteringTable table = make_scattering_table(look);
      const std::vector<glm::vec4> pixels = on_gpu(look, asked, table, true);
      const FibreShading shading(look);
      std::vector<LobeValues> truth;
      for (const Case& c : asked) truth.push_back(lobes_of(shading, look, c, table));
      for (std::size_t p = 0; p < lobe_count; ++p) {
        double peak = 0, largest = 0;
        for (const LobeValues& lobes : truth) peak = std::max(peak, lobes[p]);
        for (std::size_t i = 0; i < truth.size(); ++i) {
          const double apart = std::abs(double(pixels[i][static_cast<int>(p)]) - truth[i][p]);
          largest = std::max(largest, apart / std::max(truth[i][p], peak / 100));
        }
        EXPECT_LT(largest, 4e-3) << "model " << int(model) << " lobe " << p;
        EXPECT_EQ(peak > 0, p < 3 || model == ShadingModel::energy_conserving);
      }
    }
  }
}

/// Tests one lobe at a time of the models that are formulas: the weights of the others are 0.
TEST_P(Scattering, EveryLobeOfAFormulaAgreesWithTheCpu) {
  const std::vector<Case> asked = random_cases();
  for (const ShadingModel model : {ShadingModel::kajiya, ShadingModel::kajiya_kay, ShadingModel::scheuermann}) {
    for (int lobe = 0; lobe < 3; ++lobe) {
      Look look;
      look.shading = model;
      look.diffuse = lobe == 0, look.specular = lobe == 1, look.fibre.secondary_specular = lobe == 2;
      EXPECT_LT(largest_difference(look, asked, {}, on_gpu(look, asked, {})), 1e-3) << int(model) << " lobe " << lobe;
    }
  }
}

/// The light that a white fibre sends into one direction, summed on the GPU over light from everywhere, is pi, since
/// `scatter` is pi times a distribution. Gauss-Legendre quadrature along the strand, midpoints around it.
TEST_P(Scattering, WhiteFurnace) {
  Look look;
  look.shading = ShadingModel::energy_conserving;
  const ScatteringTable table = make_scattering_table(look);
  for (const double view_sine : {-0.8, 0.0, 0.5}) {
    std::vector<Case> asked;
    std::vector<double> weights;
    const glm::vec3 to_camera(view_sine, std::sqrt(1 - view_sine * view_sine), 0);
    for (const QuadratureNode& node : gauss_legendre(side, -1.0, 1.0)) {
      for (int i = 0; i < side; ++i) {
        const double around = 2 * 3.14159265358979 * (i + 0.5) / side, across = std::sqrt(1 - node.x * node.x);
        const glm::vec3 to_light(node.x, across * std::cos(around), across * std::sin(around));
        asked.push_back({{1, 0, 0}, {0, 1, 0}, to_light, to_camera, glm::vec3(1), 0.5f});
        weights.push_back(node.weight * 2 / side);
      }
    }
    const std::vector<glm::vec4> pixels = on_gpu(look, asked, table);
    double sum = 0;
    for (std::size_t i = 0; i < pixels.size(); ++i) sum += weights[i] * double(pixels[i].g);
    EXPECT_NEAR(sum, 1, 1e-3) << view_sine;
  }
}

TEST_P(Scattering, LightFromBehindAgreesWithTheCpu) {
  const std::vector<Case> asked = random_cases();
  for (const ShadingModel model : all_models) {
    Look look;
    look.shading = model;
    const std::vector<glm::vec4> pixels = on_gpu(look, asked, make_scattering_table(look));
    for (std::size_t i = 0; i < asked.size(); ++i) {
      const double facing = glm::dot(glm::dvec3(asked[i].normal), glm::dvec3(asked[i].to_light));
      ASSERT_NEAR(double(pixels[i].a), backlight_fade(model, facing, 0.5), 1e-5) << "model " << int(model);
    }
  }
}

TEST_P(Scattering, ExtremesAreFinite) {
  const std::vector<Case> asked = extreme_cases();
  for (const ShadingModel model : all_models) {
    for (const double roughness : {0.0, 1e-4, 1.0}) {
      for (const double eta : {1.0, 1 + 1e-6, 3.0}) {
        Look look;
        look.shading = model;
        look.fibre.longitudinal_roughness = look.fibre.azimuthal_roughness = roughness;
        look.fibre.highlight_width = 90 * roughness;
        look.fibre.refractive_index = eta;
        look.fibre.cuticle_tilt = 15;
        look.diffuse_exponent = look.specular_exponent = look.fibre.secondary_exponent = roughness < 1 ? 1e6 : 0;
        for (const glm::vec4& pixel : on_gpu(look, asked, make_scattering_table(look))) {
          for (int channel = 0; channel < 3; ++channel) {
            ASSERT_TRUE(std::isfinite(pixel[channel]) && pixel[channel] >= 0)
                << "model " << int(model) << " roughness " << roughness << " eta " << eta << ": " << pixel[channel];
          }
        }
      }
    }
  }
}

INSTANTIATE_TEST_SUITE_P(Gl, Scattering, both_backends(), name_of);

}  // namespace
}  // namespace testing::scattering_test
}  // namespace pelage
