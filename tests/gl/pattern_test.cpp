// The GLSL mixing of a pattern's colours against the C++ one, and patterns in whole frames.
#include "renderer/pattern/pattern.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include "renderer/gl/handles.h"
#include "renderer/gl/program.h"
#include "tests/gl/with_renderer.h"
#include "tests/support/furred_model.h"

namespace pelage {
namespace shaders {
extern const char* const lean_grid_vert;
extern const char* const pattern_grid_frag;
}  // namespace shaders

namespace testing::pattern_test {
namespace {

constexpr int side = 33;

class PatternOnGpu : public WithRenderer {};

TEST_P(PatternOnGpu, MixesAsTheCpuDoes) {
  Coat coat;
  coat.pattern.kind = PatternKind::rosettes;
  const PatternBlock block = make_pattern_block(coat);
  const std::array<glm::vec4, 5> uniforms{block.colour, block.inner_colour, block.belly_colour,
                                          glm::vec4(0, 0, 0, block.axis.w), glm::vec4(1)};
  const RenderTarget target(gl(), GL_RGBA32F, side, side, false);
  const Program program(gl(), shaders::lean_grid_vert, shaders::pattern_grid_frag);
  ASSERT_EQ(program.log(), "");
  const VertexArray nothing(gl());
  const Buffer buffer(gl());
  gl().NamedBufferData(buffer.id(), sizeof uniforms, &uniforms, GL_STATIC_DRAW);
  gl().BindBufferBase(GL_UNIFORM_BUFFER, 1, buffer.id());
  gl().BindFramebuffer(GL_FRAMEBUFFER, target.framebuffer());
  gl().Viewport(0, 0, side, side);
  gl().BindVertexArray(nothing.id());
  program.use();
  gl().DrawArrays(GL_TRIANGLES, 0, 3);
  std::vector<glm::vec4> values(side * side);
  gl().ReadPixels(0, 0, side, side, GL_RGBA, GL_FLOAT, values.data());
  for (int y = 0; y < side; ++y) {
    for (int x = 0; x < side; ++x) {
      const glm::vec2 at = glm::vec2(x, y) / 32.0f;
      const glm::vec3 weights(at.x, glm::fract(3.0f * at.x + 0.3f), glm::fract(5.0f * at.x + at.y));
      const glm::vec3 expected = with_weights(block, weights, {at.y, 0.5f * at.y, 0.2f});
      const glm::vec3 apart = glm::abs(glm::vec3(values[static_cast<std::size_t>(y * side + x)]) - expected);
      ASSERT_LT(std::max({apart.x, apart.y, apart.z}), 1e-5f) << x << " " << y;
    }
  }
}

TEST_P(PatternOnGpu, StripesShowOnFurAndOnShortFurToo) {
  for (const double length : {0.02, 0.002}) {
    FurredModel model = furred({Builtin::sphere, 1000}, {.length = length});
    const Image plain = draw(*renderer, model, shells_frame());
    model.settings.coats[0].coat.pattern.kind = PatternKind::stripes;
    model.settings.coats[0].coat.pattern.scale = 0.2;
    model.settings.coats[0].coat.pattern.colour = {0, 0, 0};
    const Image striped = draw(*renderer, model, shells_frame());
    int darker = 0, same = 0;
    for (std::size_t i = 0; i < plain.rgba.size(); i += 4) {
      if (plain.rgba[i + 3] < 255) continue;
      if (striped.rgba[i] < plain.rgba[i] / 2)
        ++darker;
      else if (std::abs(striped.rgba[i] - plain.rgba[i]) <= 2)
        ++same;
    }
    EXPECT_GT(darker, 500) << length;
    EXPECT_GT(same, 500) << length;
  }
}

TEST_P(PatternOnGpu, VariationOfLengthChangesTheSilhouette) {
  FurredModel model = furred({Builtin::sphere, 1000}, {.length = 0.06, .inclination = 0.1});
  const Image even = draw(*renderer, model, shells_frame());
  model.settings.coats[0].coat.variation.length = 0.8;
  EXPECT_GT(mean_difference(even, draw(*renderer, model, shells_frame())), 1);
}

INSTANTIATE_TEST_SUITE_P(Gl, PatternOnGpu, both_backends(), name_of);

}  // namespace
}  // namespace testing::pattern_test
}  // namespace pelage
