// Strands drawn by compute shaders look like the same strands drawn by the CPU.
#include "renderer/raster/gpu/gpu_raster.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <fstream>

#include "renderer/coat/strand_tile.h"
#include "renderer/image/cropped.h"
#include "renderer/picture_files/picture_files.h"
#include "server/builtin/builtin.h"
#include "server/frames/fur_view.h"
#include "server/scene/creature_settings.h"
#include "tests/gl/backends.h"
#include "tests/gl/flip.h"
#include "tests/support/golden_scenes.h"
#include "tests/support/textured.h"

namespace pelage::testing {
namespace {

/// Leaves few strands, and makes them wide, so that some still cover whole pixels.
void thin_out(Coat& coat) {
  coat.count /= 32;
  coat.width_root *= 4, coat.width_tip *= 4;
}

/// A golden scene that a software GL draws in less than a second: a small picture of few strands.
GoldenScene small_scene(std::size_t number, int size = 128) {
  GoldenScene scene(goldens()[number], size);
  thin_out(scene.model.settings.coats[0].coat);
  return scene;
}

/// Draws the same scenes by the GL and by the CPU.
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

  /// Expects differences of at most a twentieth of what issue 44 allows, since more would hide a fault. If
  /// PELAGE_PICTURES names a folder, both pictures are written to it.
  void expect_same(const FurredModel& model, const FrameRequest& request, const std::string& name) {
    const Image expected = draw(by_cpu, model, request);
    gl().take_counts();
    const Image drawn = draw(*by_gl, model, request);
    EXPECT_GT(gl().take_counts().programs, 0u) << name << " was not drawn by the GL";
    EXPECT_LE(mean_difference(expected, drawn), 0.05) << name;
    EXPECT_LE(flip_between(expected, drawn), 0.001) << name;
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
  GoldenScene scene = small_scene(1, 64);
  for (const Tier tier : {Tier::draft, Tier::interactive, Tier::detailed}) {
    scene.request.knobs = knobs_of(tier);
    expect_same(scene.model, scene.request, "tier_" + std::to_string(static_cast<int>(tier)));
  }
}

/// The creature with its eyes, whiskers and bare skin, wet, over the ground.
GoldenScene whole_creature(int size) {
  GoldenScene scene = small_scene(0, size);
  scene.model.model.name = "creature";
  scene.model.settings = first_settings(scene.model.model);
  thin_out(scene.model.settings.coats[0].coat), scene.model.settings.coats[0].coat.wetness = 0.5;
  scene.model.settings.ground.visible = true;
  CurveGroup whisker;
  const Mesh& mesh = scene.model.model.surface.mesh();
  whisker.curves = {{mesh.to_model({0.03, 0.1, 0.42}), mesh.to_model({0.2, 0.14, 0.5})}};
  scene.model.settings.curves.push_back(whisker);
  return scene;
}

TEST_P(GpuRasterTwin, DrawsEyesCurvesBareSkinAndTheGround) {
  const GoldenScene scene = whole_creature(128);
  ASSERT_FALSE(scene.model.settings.eyes.empty());
  ASSERT_FALSE(scene.model.settings.skin.empty());
  expect_same(scene.model, scene.request, "whole_creature");
}

TEST_P(GpuRasterTwin, DrawsAFaceFromNear) {  // single strands cast shadows, an eye is large
  GoldenScene scene = whole_creature(96);
  const Mesh& mesh = scene.model.model.surface.mesh();
  const Eye& eye = scene.model.settings.eyes.front();
  scene.request.camera.automatic = AutoView::none;
  scene.request.camera.target = eye.position;
  scene.request.camera.position = eye.position + (mesh.to_model({0.1, 0.1, 1}) - mesh.to_model({0, 0, 0})) * 0.12;
  scene.request.camera.fov_degrees = 40;
  expect_same(scene.model, scene.request, "near_face");
}

TEST_P(GpuRasterTwin, DrawsAModelsOwnPicture) {
  FurredModel model = furred(with_planar_uvs(make_builtin({Builtin::creature, 1000})));
  model.skin_texture = red_and_blue(), model.settings.skin_texture = "picture";
  model.settings.look.colour_source = ColourSource::model;
  model.settings.coats[0].coat.count /= 8;
  expect_same(model, small_frame(AutoView::front, 96), "picture");
}

TEST_P(GpuRasterTwin, DrawsFromWithinTheFur) {
  GoldenScene scene = small_scene(0, 64);
  scene.request.camera.automatic = AutoView::none;
  scene.request.camera.position = scene.model.model.surface.mesh().to_model({0, 0.12, 0.15});
  scene.request.camera.target = scene.model.model.surface.mesh().to_model({0.3, 0.1, 0.3});
  expect_same(scene.model, scene.request, "within");
}

TEST_P(GpuRasterTwin, DrawsTheSameBitsAgain) {
  GoldenScene scene = small_scene(0, 96);
  const Image before = draw(*by_gl, scene.model, scene.request);
  const Groom groom = scene.model.fields.at(5);
  scene.model.fields.set(5, stored_groom(groom.direction, 2 * groom.length, 0));
  EXPECT_NE(draw(*by_gl, scene.model, scene.request).rgba, before.rgba);
  scene.model.fields.set(5, groom);  // everything is computed anew
  EXPECT_EQ(draw(*by_gl, scene.model, scene.request).rgba, before.rgba);
}

TEST_P(GpuRasterTwin, DrawsAPartAsItDrawsTheWhole) {
  GoldenScene scene = small_scene(0, 96);
  const Image whole = draw(*by_gl, scene.model, scene.request);
  scene.request.crop = Crop{20, 37, 41, 30};
  const Image part = draw(*by_gl, scene.model, scene.request);
  ASSERT_EQ(part.width, 41);
  EXPECT_EQ(cropped(whole, 20, 37, 41, 30).rgba, part.rgba);
}

TEST_P(GpuRasterTwin, FollowsAStroke) {
  GoldenScene scene = small_scene(0, 96);
  draw(*by_gl, scene.model, scene.request);
  Groom groom = scene.model.fields.at(5);
  for (std::uint32_t v = 0; v < 200; ++v) scene.model.fields.set(v, stored_groom(groom.direction, 2 * groom.length, 0));
  expect_same(scene.model, scene.request, "stroke");
}

TEST_P(GpuRasterTwin, DrawsTwoModelsInTurns) {
  const GoldenScene first = small_scene(0, 64), second = small_scene(1, 64);
  const Image of_first = draw(*by_gl, first.model, first.request),
              of_second = draw(*by_gl, second.model, second.request);
  EXPECT_NE(of_first.rgba, of_second.rgba);
  EXPECT_EQ(draw(*by_gl, first.model, first.request).rgba, of_first.rgba);
  EXPECT_EQ(draw(*by_gl, second.model, second.request).rgba, of_second.rgba);
}

TEST_P(GpuRasterTwin, FollowsALight) {
  GoldenScene scene = small_scene(0, 64);
  draw(*by_gl, scene.model, scene.request);
  scene.model.settings.lights.front().direction = {1, -0.2, 0.1};
  expect_same(scene.model, scene.request, "light_moved");
  scene.model.settings.lights.resize(1);
  expect_same(scene.model, scene.request, "one_light");
}

TEST_P(GpuRasterTwin, FollowsALightThatStandsNear) {
  GoldenScene scene = small_scene(0, 64);
  const Mesh& mesh = scene.model.model.surface.mesh();
  Light light = scene.model.settings.lights.front();
  light.kind = LightKind::point, light.intensity *= 0.1;
  light.position = mesh.to_model({0.1, 0.5, 0.3});
  scene.model.settings.lights = {light};
  expect_same(scene.model, scene.request, "light_beside");
  scene.model.settings.lights.front().position = mesh.to_model({0.013, 0.221, 0.307});
  expect_same(scene.model, scene.request, "light_within");
}

TEST_P(GpuRasterTwin, FollowsTheWind) {
  GoldenScene scene = small_scene(3, 64);  // its coat has a pattern
  scene.model.settings.coats[0].coat.curl = 0.1;
  const Image calm = draw(*by_gl, scene.model, scene.request);
  MovedFur moved{{scene.model.fields.direction().begin(), scene.model.fields.direction().end()}};
  std::vector<glm::vec2>& blown = moved[0];
  const auto frame_of = [&](Renderer& renderer) {
    const VertexRange all{0, static_cast<std::uint32_t>(blown.size())};
    sync_scene(renderer, scene.model.view(), {all}, &moved, false);
    Result<Image> drawn = renderer.draw(make_frame(scene.model.view(), scene.request));
    return drawn ? std::move(drawn).value() : Image();
  };
  for (const float gust : {0.5f, -0.3f}) {
    for (std::size_t v = 0; v < blown.size(); ++v)
      blown[v] += gust * glm::vec2(std::cos(0.01 * static_cast<double>(v)), 1);
    const Image expected = frame_of(by_cpu), drawn = frame_of(*by_gl);
    EXPECT_GT(mean_difference(expected, calm), 0.5) << "the wind is seen";
    EXPECT_LE(mean_difference(expected, drawn), 0.05);
    EXPECT_LE(flip_between(expected, drawn), 0.001);
  }
  EXPECT_EQ(draw(*by_gl, scene.model, scene.request).rgba, calm.rgba) << "it stands as it did";
}

/// All AOVs but the beauty. The CPU draws those of objects.
TEST_P(GpuRasterTwin, ShowsWhatIsAskedForBesideLight) {
  const GoldenScene scene = whole_creature(64);
  const std::vector<Aov> aovs{Aov::alpha,     Aov::depth,  Aov::position, Aov::normal,       Aov::tangent,
                              Aov::albedo,    Aov::direct, Aov::shadow,   Aov::sample_count, Aov::objects_1,
                              Aov::objects_2, Aov::strand, Aov::root};
  const auto pictures = [&](Renderer& renderer) {
    draw(renderer, scene.model, scene.request);  // gives the renderer the model
    Result<std::vector<FloatImage>> drawn = renderer.draw_aovs(make_frame(scene.model.view(), scene.request), aovs);
    EXPECT_TRUE(drawn.ok()) << drawn.status().message;
    return std::move(drawn).value();
  };
  const std::vector<FloatImage> expected = pictures(by_cpu), drawn = pictures(*by_gl);
  for (std::size_t i = 0; i < aovs.size(); ++i) {
    std::size_t others = 0, pixels = expected[i].rgba.size() / 4;
    for (std::size_t p = 0; p < pixels; ++p) {
      const float *a = &expected[i].rgba[4 * p], *b = &drawn[i].rgba[4 * p];
      const float apart = std::max({std::abs(a[0] - b[0]), std::abs(a[1] - b[1]), std::abs(a[2] - b[2])});
      others += apart > 0.01f + 0.01f * std::max({std::abs(a[0]), std::abs(a[1]), std::abs(a[2])});
    }
    // Strands of equal coverage in a pixel, or that end at its border, may swap places. Only one of the two counts
    // strands that are hidden behind full tiles.
    const double share = static_cast<double>(others) / static_cast<double>(pixels);
    EXPECT_LE(share, aovs[i] == Aov::sample_count ? 0.3 : 0.005) << static_cast<int>(aovs[i]);
    if (std::getenv("PELAGE_PICTURES"))
      std::printf("AOV %d: %.4f of the pixels differ\n", static_cast<int>(aovs[i]), share);
  }
}

TEST_P(GpuRasterTwin, DrawsAnewAfterItsGlWasReset) {
  const GoldenScene scene = small_scene(0, 64);
  const Image expected = draw(*by_gl, scene.model, scene.request);
  Gl reset = gl();
  reset.GetGraphicsResetStatus = [] { return GLenum{GL_GUILTY_CONTEXT_RESET}; };
  const auto renderer = Renderer::create(reset, {.threads = 2, .software_gl_draws_strands = true});
  ASSERT_TRUE(renderer.ok());
  EXPECT_ANY_THROW(draw(**renderer, scene.model, scene.request));
  EXPECT_TRUE((*renderer)->lost_gl());
  ASSERT_TRUE((*renderer)->take_gl(&gl()).ok());
  EXPECT_FALSE((*renderer)->lost_gl());
  EXPECT_EQ(draw(**renderer, scene.model, scene.request).rgba, expected.rgba);
}

TEST_P(GpuRasterTwin, LeavesToTheCpuWhatItHasNoMemoryFor) {
  const GoldenScene scene = small_scene(3, 64);  // it has a ground, which must be darkened only once
  static int answers = 0;                        // that are left; every second one is GL_OUT_OF_MEMORY
  Gl poor = gl();
  poor.GetError = [] { return answers > 0 && answers-- % 2 == 0 ? GLenum{GL_OUT_OF_MEMORY} : GLenum{GL_NO_ERROR}; };
  const auto renderer = Renderer::create(poor, {.threads = 2, .software_gl_draws_strands = true});
  ASSERT_TRUE(renderer.ok());
  gl().GetError();  // clears the error of a query that shells try
  answers = 4;      // two for the picture that is finished on the GPU, two for its light
  EXPECT_EQ(draw(**renderer, scene.model, scene.request).rgba, draw(by_cpu, scene.model, scene.request).rgba);
  EXPECT_EQ(answers, 0);
  EXPECT_TRUE((*renderer)->strands_by_gl());  // the next frame may fit
}

/// Adds a second coat, long, curled and wet, whose density falls from one side of the model to the other.
void add_second_coat(FurredModel& model) {
  NamedCoat second{"mane", 3, false, model.settings.coats[0].coat};
  second.coat.seed = 7, second.coat.curl = 0.1, second.coat.wetness = 0.6, second.coat.ramp = {{0, {0.1f, 0.2f, 0.6f}}};
  model.settings.coats.push_back(second);
  const FieldSet first = model.fields;
  model.fields.select(3);
  for (std::uint32_t v = 0; v < first.size(); ++v) {
    const float side = model.model.surface.mesh().positions[v].x + 0.5f;
    model.fields.set(Field::direction, v, first.value(Field::direction, v));
    model.fields.set(Field::length, v, 2.0f * first.value(Field::length, v));
    model.fields.set(Field::density, v, {std::clamp(side, 0.0f, 1.0f), 0, 0, 0});
  }
  model.fields.select(0);
}

TEST_P(GpuRasterTwin, DrawsSeveralCoats) {
  GoldenScene scene(goldens()[1], 128);
  scene.model.settings.coats[0].coat.count /= 8;
  const Image one = draw(by_cpu, scene.model, scene.request);
  add_second_coat(scene.model);
  EXPECT_GT(mean_difference(one, draw(by_cpu, scene.model, scene.request)), 3) << "it is seen";
  expect_same(scene.model, scene.request, "coats");
}

/// Draws the light of a scene by a GL, with buffers of at most `max_bytes`.
Result<FloatImage> light_in_buffers(const Gl& gl, const GoldenScene& golden, std::size_t max_bytes) {
  const ModelArrays arrays = make_arrays(golden.model.view());
  const FurModel model = make_model(golden.model.view(), arrays);
  const FurFrame frame = make_frame(golden.model.view(), golden.request);
  GrownFur fur;
  fur.update(model, make_fields(golden.model.view(), {}, {}), GrowRecipe{.coat = frame.coat()}, 2);
  Raster raster(2);
  const RasterScene scene =
      raster.scene_of(model, fur, frame, quality_of(frame.knobs, winding(frame.coat())), RasterOutput::light);
  const auto drawer = GpuRaster::create(gl, max_bytes);
  if (!drawer) return drawer.status();
  auto picture = empty_picture<FloatImage>(frame.width, frame.height);
  RasterCounts counts;
  const Status drawn = (*drawer)->draw_box(scene, {0, 0, frame.width, frame.height}, picture, counts);
  if (!drawn.ok()) return drawn;
  return picture;
}

TEST_P(GpuRasterTwin, DrawsInBandsWhereBuffersAreSmall) {
  GoldenScene scene = small_scene(1, 96);
  scene.model.settings.coats[0].coat.count /= 4;
  const Result<FloatImage> whole = light_in_buffers(gl(), scene, ~std::size_t{0});
  const Result<FloatImage> bands = light_in_buffers(gl(), scene, std::size_t{300} << 10);
  ASSERT_TRUE(whole.ok() && bands.ok());
  EXPECT_EQ(whole->rgba, bands->rgba);
  const Result<FloatImage> none = light_in_buffers(gl(), scene, 1024);  // too small even for one row of tiles
  EXPECT_EQ(none.status().code, Code::too_large);
}

INSTANTIATE_TEST_SUITE_P(Gl, GpuRasterTwin, both_backends(), name_of);

}  // namespace
}  // namespace pelage::testing
