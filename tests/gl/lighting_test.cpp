// The light on a fibre in GLSL against the formulas of GPU fur eq 1 to 3 and of science.md 4, in double.
#include <algorithm>
#include <cmath>
#include <numbers>
#include <random>

#include "base/colour_space.h"
#include "renderer/coat/slices.h"
#include "renderer/light/environment.h"
#include "renderer/shading/scattering_table.h"
#include "renderer/upload/blocks.h"
#include "tests/double_shading/fibre_shading.h"
#include "tests/gl/backends.h"
#include "tests/gl/expected_light.h"
#include "tests/gl/grid.h"

namespace pelage {
namespace shaders {
extern const char* const lean_grid_vert;
extern const char* const lighting_grid_frag;
}  // namespace shaders

namespace testing::lighting_test {
namespace {

constexpr int side = 32, cases = side * side;
constexpr int asked_light = 2;  // index of the light whose shadow is asked for; its maps are the second ones

std::vector<Case> random_cases() {
  std::mt19937 random(5);
  const auto number = [&] { return static_cast<float>(random()) / 4294967296.0f; };
  const auto direction = [&] {
    const float z = 2 * number() - 1, turn = 6.2831853f * number(), r = std::sqrt(1 - z * z);
    return glm::vec3(r * std::cos(turn), r * std::sin(turn), z);
  };
  std::vector<Case> made;
  for (int i = 0; i < cases; ++i) {
    Case c;
    c.position = 0.6f * glm::vec3(number(), number(), number()) - 0.3f;
    c.normal = direction(), c.tangent = direction(), c.to_camera = direction();
    c.colour = {number(), number(), number()};
    c.height = number(), c.above = 3 * number(), c.strand = number();
    made.push_back(c);
  }
  return made;
}

enum Asked { whole_light, transmitted, surroundings, arriving, direct, unshadowed, mapped };

class Lighting : public OnBackend {
 protected:
  std::vector<glm::vec4> on_gpu(Asked asked, const FurFrame& frame, const std::vector<Case>& of,
                                const std::string& defines = {}) {
    const Program program(gl(), shaders::lean_grid_vert, shaders::lighting_grid_frag, defines);
    EXPECT_EQ(program.log(), "");
    const Buffer block = send_block(gl(), 0, make_frame_block(frame, Slices{}, false, side));
    const Buffer scattering = send_block(gl(), 3, scattering_block(frame.look));
    std::vector<glm::vec4> texels;
    for (const Case& c : of) texels.emplace_back(c.position, c.height);
    for (const Case& c : of) texels.emplace_back(c.normal, c.above);
    for (const Case& c : of) texels.emplace_back(c.tangent, c.strand);
    for (const Case& c : of) texels.emplace_back(c.to_camera, 0);
    for (const Case& c : of) texels.emplace_back(c.colour, 0);
    const Texture inputs = send_images(gl(), side, texels);
    gl().BindTextureUnit(0, inputs.id());
    program.use();
    program.set("asked", static_cast<int>(asked));
    program.set("light", asked_light);
    return answers(gl(), side);
  }
};

FurFrame lit_frame() {
  FurFrame frame;
  frame.width = frame.height = side;
  frame.look.shading = ShadingModel::kajiya;  // the default of lighting.glsl
  frame.look.back_attenuation = 0.7, frame.look.self_shadow = 0.8, frame.look.ambient_floor = 0.2;
  frame.environment = {
      .sky = {1, 0.5f, 0.2f}, .horizon = {0.2f, 0.4f, 0.6f}, .ground = {0.3f, 0.1f, 0}, .harmonics = {}};
  frame.lights = {{.kind = LightKind::directional,
                   .direction = glm::normalize(glm::vec3(1, -2, 0.5f)),
                   .radiance = {1, 0.8f, 0.5f}},
                  {.kind = LightKind::point, .position = {0.5f, 0.9f, -0.6f}, .radiance = {0.1f, 0.3f, 0.6f}},
                  {.kind = LightKind::spot,
                   .direction = {0, -1, 0},
                   .position = {0, 1.5f, 0},
                   .radiance = {0.8f, 0.9f, 0.3f},
                   .cone = 0.95f,
                   .soft_cone = 0.99f},
                  {.kind = LightKind::area,
                   .direction = glm::normalize(glm::vec3(-1, 0.2f, -0.3f)),
                   .position = {0.1f, 0.2f, -0.1f},
                   .radiance = {0.02f, 0.05f, 0.03f},
                   .cone = 0,
                   .soft_cone = 1,
                   .extent = {0.3f, 0.2f}}};
  return frame;
}

double apart(const glm::vec4& value, const glm::dvec3& truth) {
  return glm::length(glm::dvec3(value) - truth) / std::max(1.0, glm::length(truth));
}

TEST_P(Lighting, SumsUpAmbientLightAndLights) {
  FurFrame frame = lit_frame();
  const std::vector<Case> of = random_cases();
  for (const ShadingModel model : {ShadingModel::kajiya, ShadingModel::kajiya_kay, ShadingModel::scheuermann}) {
    frame.look.shading = model;
    const std::string defines = "#define ENVIRONMENT\n#define SHADING_MODEL " + std::to_string(int(model)) + "\n";
    const std::vector<glm::vec4> values = on_gpu(whole_light, frame, of, defines);
    const FibreShading shading(frame.look);
    for (std::size_t i = 0; i < of.size(); ++i) {
      ASSERT_LT(apart(values[i], expected_light(frame, shading, of[i]).light), 1e-4) << int(model) << " " << i;
    }
  }
}

/// A program that is built for far lights alone gives the same light as one for any lights.
TEST_P(Lighting, FarLightsAloneGiveTheSameLight) {
  FurFrame frame = lit_frame();
  frame.lights.resize(1);
  frame.lights.push_back(
      {.kind = LightKind::directional, .direction = {0.6f, -0.8f, 0}, .radiance = {0.2f, 0.4f, 0.9f}});
  const std::vector<Case> of = random_cases();
  const std::vector<glm::vec4> any = on_gpu(whole_light, frame, of);
  const std::vector<glm::vec4> far = on_gpu(whole_light, frame, of, "#define FAR_LIGHTS\n#define LIGHTS 2\n");
  for (std::size_t i = 0; i < of.size(); ++i) ASSERT_LT(apart(far[i], glm::dvec3(any[i])), 1e-6) << i;
}

/// Fibre models compute single scattering; .55 kd C sin(T, L) stands for further scattering between fibres.
TEST_P(Lighting, FibreModelsScatterAgainInTheFursColour) {
  FurFrame frame = lit_frame();
  frame.lights.resize(1), frame.look.ambient = 0, frame.look.self_shadow = 0;
  frame.look.shading = ShadingModel::energy_conserving;
  const Texture nothing(gl(), GLenum{GL_TEXTURE_3D});  // a table without single scattering
  const glm::vec4 zero(0);
  gl().TextureStorage3D(nothing.id(), 1, GL_RGBA32F, 1, 1, 1);
  gl().TextureSubImage3D(nothing.id(), 0, 0, 0, 0, 1, 1, 1, GL_RGBA, GL_FLOAT, &zero);
  gl().BindTextureUnit(3, nothing.id());
  const std::vector<Case> of = random_cases();
  const std::vector<glm::vec4> values = on_gpu(whole_light, frame, of, "#define SHADING_MODEL 2\n");
  const glm::dvec3 to_light = -glm::dvec3(frame.lights[0].direction), radiance(frame.lights[0].radiance);
  for (std::size_t i = 0; i < of.size(); ++i) {
    const double along = glm::dot(glm::dvec3(of[i].tangent), to_light);
    const glm::dvec3 again = 0.55 * frame.look.diffuse * glm::dvec3(of[i].colour) * std::sqrt(1 - along * along);
    ASSERT_LT(apart(values[i], radiance * again), 1e-5) << i;
  }
}

/// Below two strands on average black fur transmits exp(-2 (1 - t)), and paler fur more (science.md 4).
TEST_P(Lighting, PaleFurLetsLightThroughInItsColour) {
  std::vector<Case> of = random_cases();
  of[0].colour = {0, 0.25f, 1}, of[0].above = 2;
  FurFrame frame = lit_frame();
  frame.look.self_shadow = 1;
  const std::vector<glm::vec4> values = on_gpu(transmitted, frame, of);
  for (std::size_t i = 0; i < of.size(); ++i) {
    ASSERT_LT(apart(values[i], transmittance_of(frame.look, double(of[i].above), glm::dvec3(of[i].colour))), 1e-5);
  }
  EXPECT_NEAR(values[0].r, std::exp(-2 * (1 - std::exp(-2))), 1e-5);
  EXPECT_GT(values[0].g, 1.3f * values[0].r);
  EXPECT_GT(values[0].b, 0.5f);
}

/// The approximation against the mean of exp(-a tan x) over the hemisphere.
TEST(AmbientShare, IsNearTheMeanOverAllDirections) {
  for (const double a : {0.01, 0.1, 0.5, 1.0, 3.0, 10.0}) {
    double mean = 0;
    constexpr int steps = 20000;
    for (int i = 0; i < steps; ++i) {
      const double x = (i + 0.5) / steps * std::numbers::pi / 2;
      mean += std::sin(2 * x) * std::exp(-a * std::tan(x)) * std::numbers::pi / 2 / steps;
    }
    EXPECT_NEAR(from_all_around(a), mean, 0.01) << a;
  }
}

TEST_P(Lighting, SurroundingsAreTheHarmonicsOfTheFrame) {
  FurFrame frame = lit_frame();
  std::mt19937 random(9);
  SphericalHarmonics harmonics;
  for (glm::dvec3& v : harmonics) {
    for (int k = 0; k < 3; ++k) v[k] = static_cast<double>(random()) / 4294967296.0 - 0.4;
  }
  harmonics[0] += 2.0;
  frame.environment.harmonics = harmonics, frame.environment.turn_degrees = 30;
  const SphericalHarmonics around = irradiance_of(harmonics_of(frame.environment));
  const std::vector<Case> of = random_cases();
  const std::vector<glm::vec4> values = on_gpu(surroundings, frame, of, "#define ENVIRONMENT\n");
  for (std::size_t i = 0; i < of.size(); ++i) {
    ASSERT_LT(apart(values[i], glm::max(evaluate(around, glm::dvec3(of[i].normal)), 0.0)), 1e-5);
  }
  const std::vector<glm::vec4> constant = on_gpu(surroundings, frame, of);
  EXPECT_EQ(glm::vec3(constant[0]), glm::vec3(1));
}

TEST_P(Lighting, LightsFallWithTheSquareSpotsToTheirEdgeAndAreasByTheCosine) {
  const FurFrame all = lit_frame();
  const std::vector<Case> of = random_cases();
  for (const FurLight& light : all.lights) {
    FurFrame frame = all;
    frame.lights = {light};
    const std::vector<glm::vec4> values = on_gpu(arriving, frame, of);
    int part = 0;
    for (std::size_t i = 0; i < of.size(); ++i) {
      const Arriving truth = arriving_from(light, glm::dvec3(of[i].position));
      ASSERT_LT(apart(values[i], truth.to_light), 1e-5);
      ASSERT_NEAR(values[i].a, truth.radiance.g, 2e-5 * std::max(1.0, truth.radiance.g));
      const double full =
          truth.radiance.g /
          arriving_from({.kind = LightKind::point, .position = light.position, .radiance = light.radiance},
                        glm::dvec3(of[i].position))
              .radiance.g;
      part += full > 0.01 && full < 0.99;
    }
    EXPECT_GE(part, light.kind == LightKind::spot || light.kind == LightKind::area ? 50 : 0);
  }
}

/// A light above looks down -Z. Its map holds skin at depth .5 everywhere; the first map is that of another light.
class ShadowFormulas : public Lighting {
 protected:
  struct Maps {
    float white = 1;  // value of the shadow-width map
    bool soft = true;
    float scale = 10;              // Cscale; -1 casts no shadow
    float shells = 1, depths = 1;  // array indices of the maps; -1 for none
    float lower = 0.5f;            // depth of the skin on the map's lower half
  };

  /// Returns rg: S, and the optical depth of the shells above, at the cases' positions and heights. The estimate is 7.
  std::vector<glm::vec4> asked(const Maps& maps, const std::vector<Case>& of) {
    ShadowBlock block;
    block.to_light[asked_light] = glm::mat4(1);
    block.axis[asked_light] = {0, 0, -1, 0.5f};
    block.slots[asked_light] = {maps.shells, maps.depths, maps.soft ? 1 : 0, maps.scale};
    const Buffer buffer = send_block(gl(), 2, block);
    const auto texels = [&](glm::vec4 value) { return std::vector<glm::vec4>(4, value); };
    std::vector<glm::vec4> shells, depths = texels(glm::vec4(0.1f)), widths = texels(glm::vec4(0.9f));
    for (int shell = 0; shell <= 16; ++shell) shells.insert(shells.end(), 4, glm::vec4(0.5f));
    for (int shell = 0; shell <= 16; ++shell)
      shells.insert(shells.end(), 4, glm::vec4(std::exp(0.2f * float(shell - 16))));
    depths.insert(depths.end(), 2, glm::vec4(0.5f)), depths.insert(depths.end(), 2, glm::vec4(maps.lower));
    widths.insert(widths.end(), 4, glm::vec4(maps.white, 0.5f * maps.white, 0, 0));  // cast by the skin at depth .5
    const Texture shell_maps = send_images(gl(), 2, shells, true);
    const Texture depth_maps = send_images(gl(), 2, depths, true);
    const Texture width_maps = send_images(gl(), 2, widths, true);
    gl().BindTextureUnit(4, shell_maps.id());
    gl().BindTextureUnit(5, depth_maps.id());
    gl().BindTextureUnit(6, width_maps.id());
    return on_gpu(mapped, lit_frame(), of, "#define SHADOW_MAPS\n");
  }

  /// Points up to `deepest` below the skin that the light sees.
  static std::vector<Case> positions_below(double deepest) {
    std::vector<Case> of = random_cases();
    for (std::size_t i = 0; i < of.size(); ++i) {
      of[i].position.z = static_cast<float>(-deepest * double(i) / cases);
      of[i].height = static_cast<float>(i) / cases;
    }
    return of;
  }
};

/// S = clamp(1 - Cscale sw / sd, 0, 1) behind what the light sees, 1 in front of it (GPU fur 4), past the bias.
TEST_P(ShadowFormulas, SoftShadowIsTheWidthOverTheDepth) {
  const std::vector<Case> of = positions_below(0.3);
  for (const float white : {0.4f, 0.55f, 0.7f, 1.0f}) {
    for (const float scale : {0.5f, 2.0f, 10.0f}) {
      const std::vector<glm::vec4> values = asked({.white = white, .scale = scale}, of);
      const double sw = 0.03 * std::max(2 * double(white) - 1, 0.0);
      for (std::size_t i = 0; i < of.size(); ++i) {
        const double sd = -double(of[i].position.z);
        if (sd > 0.0059 && sd < 0.0181) continue;  // the bias fades in
        const double expected = sd < 0.006 ? 1 : 1 - std::clamp(double(scale) * sw / sd, 0.0, 1.0);
        ASSERT_NEAR(values[i].r, expected, 2e-5) << white << " " << sd;
      }
    }
  }
}

TEST_P(ShadowFormulas, HardShadowIsAllOrNothingPastTheBias) {
  const std::vector<Case> of = positions_below(0.02);
  const std::vector<glm::vec4> hard = asked({.soft = false}, of), none = asked({.scale = -1}, of);
  for (std::size_t i = 0; i < of.size(); ++i) {
    const double sd = -double(of[i].position.z);
    ASSERT_EQ(none[i].r, 1);
    if (std::abs(sd - 0.006) < 1e-5) continue;
    ASSERT_EQ(hard[i].r, sd < 0.006 ? 1 : 0);
  }
}

/// The maps hold exp(-.2 (16 - i)) at boundary i, and transmittance is interpolated between boundaries. The lookup
/// starts a quarter of a shell (half a slice) higher, because that part is the strand itself.
TEST_P(ShadowFormulas, ShellsTransmitWhatTheirMapsSay) {
  const std::vector<Case> of = positions_below(0);
  const std::vector<glm::vec4> values = asked({}, of);
  for (std::size_t i = 0; i < of.size(); ++i) {
    const double shell = std::min(16 * double(of[i].height) + 0.25, 16.0), low = std::min(std::floor(shell), 15.0);
    const double transmittance = glm::mix(std::exp(0.2 * (low - 16)), std::exp(0.2 * (low - 15)), shell - low);
    ASSERT_NEAR(values[i].g, -std::log(transmittance), 1e-4) << of[i].height;
  }
  for (const glm::vec4& value : asked({.shells = -1}, of)) ASSERT_EQ(value.g, 7);  // no maps: the estimate
  const std::vector<Case> behind = positions_below(0.3);
  const std::vector<glm::vec4> other = asked({}, behind);
  EXPECT_EQ(other[cases - 1].g, 7) << "the maps show another part of the body";
}

/// The first row of a map is its upper side as the light sees it.
TEST_P(ShadowFormulas, MapsStandUpright) {
  std::vector<Case> of = positions_below(0.3);
  for (Case& c : of) c.position.y = c.position.y > 0 ? 0.6f : -0.6f;
  const std::vector<glm::vec4> values = asked({.soft = false, .lower = 0.0f}, of);
  for (std::size_t i = 0; i < of.size(); ++i) {
    const double sd = -double(of[i].position.z) + (of[i].position.y > 0 ? 0 : 0.5);
    if (std::abs(sd - 0.006) < 1e-5) continue;
    ASSERT_EQ(values[i].r, sd < 0.006 ? 1 : 0) << of[i].position.y;
  }
}

INSTANTIATE_TEST_SUITE_P(Gl, Lighting, both_backends(), name_of);
INSTANTIATE_TEST_SUITE_P(Gl, ShadowFormulas, both_backends(), name_of);

}  // namespace
}  // namespace testing::lighting_test
}  // namespace pelage
