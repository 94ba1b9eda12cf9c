// Tufts in GLSL against their definition: strands are gathered to the middle of their tuft.
#include "renderer/pattern/tufts.h"

#include <array>
#include <cmath>

#include "tests/gl/backends.h"
#include "tests/gl/grid.h"

namespace pelage {
namespace shaders {
extern const char* const tufts_grid_vert;
extern const char* const tufts_grid_frag;
}  // namespace shaders

namespace testing::tufts_test {
namespace {

constexpr int side = 16;
constexpr float longest = 0.24f;                  // range of each component of a stored pull
const glm::vec3 to_middle(0.02f, -0.03f, 0.05f);  // vector to the tuft's middle, the same everywhere
constexpr float inside = 0.4f;                    // 0 on the border between tufts, 1 in the middle; the same everywhere

class TuftsOnGpu : public OnBackend {
 protected:
  /// Evaluates a constant volume at one height; `gather` is that of the coat.
  std::vector<glm::vec4> asked(int what, float height, const Tufts& tufts) {
    const Program program(gl(), shaders::tufts_grid_vert, shaders::tufts_grid_frag);
    EXPECT_EQ(program.log(), "");
    const std::array<glm::vec4, 2> uniforms{glm::vec4(0, 0, 0, gathered(tufts, 1)), glm::vec4(1, 1, 1, longest)};
    const Buffer block = send_block(gl(), 7, uniforms);
    const Texture volume(gl(), GLenum{GL_TEXTURE_3D});
    const glm::vec4 texel((to_middle / longest + 1.0f) / 2.0f, inside);
    gl().TextureStorage3D(volume.id(), 1, GL_RGBA32F, 1, 1, 1);
    gl().TextureSubImage3D(volume.id(), 0, 0, 0, 0, 1, 1, 1, GL_RGBA, GL_FLOAT, &texel);
    gl().TextureParameteri(volume.id(), GL_TEXTURE_MIN_FILTER, GL_NEAREST);
    gl().BindTextureUnit(13, volume.id());
    program.use();
    program.set("height", height);
    program.set("asked", what);
    return answers(gl(), side);
  }
};

/// At height s, the strand with its root at r is at r + part (middle - r). So the strand at a given position has its
/// root further out, and leads from that root back to the position.
TEST_P(TuftsOnGpu, TheStrandThatIsHereHasItsRootFurtherOut) {
  const Tufts tufts{.gather = 0.8};
  for (const float s : {0.1f, 0.5f, 1.0f}) {
    for (const glm::vec4& pixel : asked(0, s, tufts)) {
      const glm::vec3 root(pixel), middle = to_middle;  // relative to here
      ASSERT_LT(glm::length(root + pixel.w * (middle - root)), 1e-6f);
      ASSERT_LE(glm::dot(root, middle), 0);
    }
    const glm::vec4 longest_fur = asked(0, s, tufts)[side * side - 1];
    EXPECT_NEAR(longest_fur.w, gathered(tufts, s), 1e-6) << "fur that is long enough gathers as the C++ says";
    EXPECT_LT(glm::dot(glm::vec3(longest_fur), to_middle), 0);
  }
}

/// The lean is the derivative of the strand's path by height, over the length of the fur.
TEST_P(TuftsOnGpu, TheLeanIsTheSlopeOfTheStrand) {
  const Tufts tufts{.gather = 1};
  constexpr float s = 0.6f, h = 1e-2f;
  const auto lean = asked(1, s, tufts), here = asked(0, s, tufts), over = asked(0, s + h, tufts),
             under = asked(0, s - h, tufts);
  for (std::size_t i = 0; i < lean.size(); ++i) {
    const float length = 0.2f * (static_cast<float>(i / side) + 0.5f) / side;
    const glm::vec3 root_to_middle = to_middle - glm::vec3(here[i]);
    const glm::vec3 slope = (over[i].w - under[i].w) / (2 * h) * root_to_middle / length;
    ASSERT_LT(glm::distance(glm::vec3(lean[i]), slope), 2e-3f * glm::length(slope)) << i;
  }
}

/// Strands converge, so fur is denser inside a tuft, and there is none where only strands of the border would be.
TEST_P(TuftsOnGpu, FurIsDenserInsideAndGoneOutside) {
  for (const float s : {0.01f, 0.4f, 1.0f}) {
    const auto share = asked(1, s, {.gather = 1}), gathering = asked(0, s, {.gather = 1});
    for (std::size_t i = 0; i < share.size(); ++i) {
      const double radius = 1 - double(gathering[i].w);
      const double border = radius - (1 - double(inside));  // above 0 inside
      ASSERT_NEAR(share[i].w, std::clamp(1 + border / 0.15, 0.0, 1.0) / radius, 1e-4);
    }
  }
  EXPECT_GT(asked(1, 0.4f, {.gather = 1})[side * side - 1].w, 1);
}

INSTANTIATE_TEST_SUITE_P(Gl, TuftsOnGpu, both_backends(), name_of);

}  // namespace
}  // namespace testing::tufts_test
}  // namespace pelage
