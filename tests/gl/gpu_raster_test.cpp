// Strands drawn by compute shaders against the same drawn by the CPU: one fur, whoever draws it.
#include <cstdlib>
#include <fstream>

#include "renderer/picture_files/picture_files.h"
#include "tests/gl/backends.h"
#include "tests/gl/flip.h"
#include "tests/support/furred_model.h"

namespace pelage::testing {
namespace {

/// Two renderers of the same scenes.
class GpuRasterTwin : public OnBackend {
 protected:
  void SetUp() override {
    OnBackend::SetUp();
    if (!context) return;
    Result<std::unique_ptr<Renderer>> made = Renderer::create(gl(), {.threads = 2, .strands_by_gl = true});
    ASSERT_TRUE(made.ok()) << made.status().message;
    by_gpu = std::move(made).value();
  }
  void TearDown() override {
    by_gpu.reset();
    OnBackend::TearDown();
  }

  std::unique_ptr<Renderer> by_gpu;
  Renderer by_cpu{{.threads = 2}};
};

TEST_P(GpuRasterTwin, DrawsTheCreatureAsTheCpuDoes) {
  const FurredModel model = furred({Builtin::creature, 4000});
  const FrameRequest request = small_frame(AutoView::three_quarter, 160);
  const Image expected = draw(by_cpu, model, request), drawn = draw(*by_gpu, model, request);
  EXPECT_LE(mean_difference(expected, drawn), 1);
  if (const char* folder = std::getenv("PELAGE_PICTURES")) {
    for (const auto& [name, image] : {std::pair{"cpu", &expected}, {"gpu", &drawn}}) {
      const std::string png = encode_png(*image, true);
      std::ofstream(std::string(folder) + "/" + name + ".png", std::ios::binary) << png;
    }
  }
}

INSTANTIATE_TEST_SUITE_P(Gl, GpuRasterTwin, both_backends(), name_of);

}  // namespace
}  // namespace pelage::testing
