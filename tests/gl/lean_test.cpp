// The GLSL lean curves against the C++ ones on a grid.
#include <cmath>
#include <vector>

#include "base/lean_curve.h"
#include "renderer/gl/handles.h"
#include "renderer/gl/program.h"
#include "tests/gl/backends.h"

namespace pelage {
namespace shaders {
extern const char* const lean_grid_vert;
extern const char* const lean_grid_frag;
}  // namespace shaders

namespace testing::lean_test {
namespace {

constexpr int side = 33;

class Lean : public OnBackend {
 protected:
  std::vector<float> on_gpu(LeanCurve curve, double root_share) {
    const RenderTarget target(gl(), GL_RGBA32F, side, side, false);
    const Program program(gl(), shaders::lean_grid_vert, shaders::lean_grid_frag);
    EXPECT_EQ(program.log(), "");
    const VertexArray nothing(gl());
    gl().BindFramebuffer(GL_FRAMEBUFFER, target.framebuffer());
    gl().Viewport(0, 0, side, side);
    gl().BindVertexArray(nothing.id());
    program.use();
    program.set("root_curve", curve == LeanCurve::root ? 1 : 0);
    program.set("root_share", static_cast<float>(root_share));
    gl().DrawArrays(GL_TRIANGLES, 0, 3);
    std::vector<float> values(4 * side * side);
    gl().ReadPixels(0, 0, side, side, GL_RGBA, GL_FLOAT, values.data());
    return values;
  }
};

TEST_P(Lean, AgreesWithTheCpu) {
  for (const LeanCurve curve : {LeanCurve::arc, LeanCurve::root}) {
    for (const double root_share : {0.0, 0.35, 1.0}) {
      const std::vector<float> values = on_gpu(curve, root_share);
      double largest = 0;
      for (int y = 0; y < side; ++y) {
        for (int x = 0; x < side; ++x) {
          const LeanPoint point = lean_point(curve, y / 32.0, root_share, x / 32.0);
          const float* gpu = &values[4 * static_cast<std::size_t>(y * side + x)];
          largest = std::max({largest, std::abs(point.across - double(gpu[0])), std::abs(point.up - double(gpu[1])),
                              std::abs(point.angle - double(gpu[2]))});
        }
      }
      EXPECT_LT(largest, 2e-5) << "curve " << int(curve) << " root share " << root_share;  // from llvmpipe's sines
    }
  }
}

INSTANTIATE_TEST_SUITE_P(Gl, Lean, both_backends(), name_of);

}  // namespace
}  // namespace testing::lean_test
}  // namespace pelage
