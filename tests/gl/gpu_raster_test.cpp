// Strands drawn by compute shaders against the same drawn by the CPU: one fur, whoever draws it.
#include <chrono>
#include <cstdlib>
#include <fstream>

#include "renderer/picture_files/picture_files.h"
#include "server/frames/fur_view.h"
#include "tests/gl/backends.h"
#include "tests/gl/flip.h"
#include "tests/support/golden_scenes.h"
#include "tests/support/textured.h"

namespace pelage::testing {
namespace {

/// A golden scene that a software GL draws in less than a second: a small picture of a few strands.
GoldenScene small_scene(std::size_t number, int size = 128) {
  GoldenScene scene(goldens()[number], size);
  scene.model.settings.coat.count /= 8;
  return scene;
}

/// The same scenes, drawn by both.
class GpuRasterTwin : public OnBackend {
 protected:
  void SetUp() override {
    OnBackend::SetUp();
    if (!context) return;
    const Result<Renderer*> made = stage.strands_renderer(GetParam());
    ASSERT_TRUE(made.ok()) << made.status().message;
    by_gl = *made;
    ASSERT_TRUE(by_gl->strands_by_gl());
  }

  /// Within the thresholds of issue 44. PELAGE_PICTURES: a folder that both pictures go to.
  void expect_same(const FurredModel& model, const FrameRequest& request, const std::string& name) {
    const auto t0 = std::chrono::steady_clock::now();
    const Image expected = draw(by_cpu, model, request);
    const auto t1 = std::chrono::steady_clock::now();
    const Image drawn = draw(*by_gl, model, request);
    const auto t2 = std::chrono::steady_clock::now();
    EXPECT_GT(gl().take_counts().programs, 0u) << name << " was not drawn by the GL";
    const Image drawn2 = draw(*by_gl, model, request);
    const auto t3 = std::chrono::steady_clock::now();
    std::printf("cpu %.3f gl %.3f again %.3f\n", std::chrono::duration<double>(t1 - t0).count(),
                std::chrono::duration<double>(t2 - t1).count(), std::chrono::duration<double>(t3 - t2).count());
    EXPECT_LE(mean_difference(expected, drawn), 1) << name;
    EXPECT_LE(flip_between(expected, drawn), 0.02) << name;
    if (const char* folder = std::getenv("PELAGE_PICTURES")) keep(expected, drawn, std::string(folder) + "/" + name);
  }

  Renderer* by_gl = nullptr;
  Renderer by_cpu{{.threads = 2}};

 private:
  static void keep(const Image& expected, const Image& drawn, const std::string& path) {
    std::ofstream(path + "_cpu.png", std::ios::binary) << encode_png(expected, true);
    std::ofstream(path + "_gl.png", std::ios::binary) << encode_png(drawn, true);
    std::printf("%s: mean %.4f of 255, largest %d, FLIP %.4f\n", path.c_str(), mean_difference(expected, drawn),
                largest_difference(expected, drawn), flip_between(expected, drawn));
  }
};

TEST_P(GpuRasterTwin, DrawsTheGoldenScenes) {
  for (std::size_t i = 0; i < goldens().size(); ++i) {
    const GoldenScene scene = small_scene(i);
    expect_same(scene.model, scene.request, goldens()[i].name);
  }
}

TEST_P(GpuRasterTwin, DrawsEveryShadingModel) {
  GoldenScene scene = small_scene(0, 96);
  for (const ShadingModel shading : {ShadingModel::lengyel, ShadingModel::kajiya, ShadingModel::energy_conserving,
                                     ShadingModel::scheuermann, ShadingModel::kajiya_kay, ShadingModel::marschner}) {
    scene.model.settings.look.shading = shading;
    expect_same(scene.model, scene.request, "shading_" + std::to_string(static_cast<int>(shading)));
  }
}

TEST_P(GpuRasterTwin, DrawsEveryTier) {
  GoldenScene scene = small_scene(1, 96);
  for (const Tier tier : {Tier::draft, Tier::interactive, Tier::detailed}) {
    scene.request.knobs = knobs_of(tier);
    expect_same(scene.model, scene.request, "tier_" + std::to_string(static_cast<int>(tier)));
  }
}

INSTANTIATE_TEST_SUITE_P(Gl, GpuRasterTwin, both_backends(), name_of);

}  // namespace
}  // namespace pelage::testing
