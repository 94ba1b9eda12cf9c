// Physics and invariants of frames of shells.
#include "renderer/frame/renderer.h"

#include <cmath>

#include "server/frames/fur_view.h"
#include "tests/gl/with_renderer.h"
#include "tests/support/furred_model.h"

namespace pelage::testing::renderer_test {
namespace {

class Frames : public WithRenderer {};

TEST_P(Frames, FurReachesBeyondTheSkin) {
  const FurredModel bare = furred({Builtin::sphere, 1000}, {.length = 0}),
                    furry = furred({Builtin::sphere, 1000}, {.length = 0.08, .inclination = 0});
  const double skin = covered(draw(*renderer, bare, shells_frame())),
               fur = covered(draw(*renderer, furry, shells_frame()));
  // The box's diagonal is 1, so the radius is .289 and upright fur of .08 makes it .369: 1.63 times the area at most.
  EXPECT_GT(fur, skin * 1.2);
  EXPECT_LT(fur, skin * 1.63);
}

TEST_P(Frames, SameFrameSameBits) {
  const FurredModel model = furred({Builtin::torus, 1000});
  const Image first = draw(*renderer, model, shells_frame());
  EXPECT_EQ(first.rgba, draw(*renderer, model, shells_frame()).rgba);
}

TEST_P(Frames, ShellCountKeepsTheOpacity) {
  // With a fixed alpha for each shell these coverages would be far apart (science.md 1).
  const FurredModel model = furred({Builtin::sphere, 1000}, {.length = 0.1, .inclination = 0.2});
  FrameRequest request = shells_frame();
  std::vector<double> means;
  for (const int shells : {16, 32, 64, 128}) {
    request.knobs.shells.count = shells;
    const Image image = draw(*renderer, model, request);
    double alpha = 0;
    for (std::size_t i = 3; i < image.rgba.size(); i += 4) alpha += image.rgba[i];
    means.push_back(alpha / static_cast<double>(image.rgba.size() / 4));
  }
  for (const double mean : means) EXPECT_NEAR(mean, means.back(), 0.03 * means.back());
}

TEST_P(Frames, MoreShellsComeCloser) {
  const FurredModel model = furred({Builtin::sphere, 1000}, {.length = 0.06, .inclination = 0.4});
  FrameRequest request = shells_frame();
  request.knobs.shells.policy = ShellPolicy::uniform;
  const auto with = [&](int shells) {
    request.knobs.shells.count = shells;
    return draw(*renderer, model, request);
  };
  const Image truth = with(256);
  const double coarse = mean_difference(with(4), truth), middle = mean_difference(with(16), truth),
               fine = mean_difference(with(64), truth);
  EXPECT_LT(middle, coarse * 0.7);
  EXPECT_LT(fine, middle * 0.7);
}

TEST_P(Frames, FewerShellsWhereTheViewNeedsFewerKeepTheOpacity) {
  const FurredModel model = furred({Builtin::sphere, 1000}, {.length = 0.1, .inclination = 0.2});
  FrameRequest request = shells_frame();
  const auto mean_alpha = [&](ShellPolicy policy) {
    request.knobs.shells.policy = policy;
    const Image image = draw(*renderer, model, request);
    double alpha = 0;
    for (std::size_t i = 3; i < image.rgba.size(); i += 4) alpha += image.rgba[i];
    return alpha / static_cast<double>(image.rgba.size() / 4);
  };
  const double uniform = mean_alpha(ShellPolicy::uniform), adaptive = mean_alpha(ShellPolicy::adaptive);
  EXPECT_NEAR(adaptive, uniform, 0.02 * uniform);
}

TEST_P(Frames, NothingPopsWhenTheCameraMoves) {
  // In a slow approach no step may change the picture much more than with uniform shells.
  const FurredModel model = furred({Builtin::sphere, 1000}, {.length = 0.06, .inclination = 0.4});
  FrameRequest request = shells_frame();
  request.camera.automatic = AutoView::none;
  request.camera.target = {0, 0, 0};
  const auto largest_change = [&](ShellPolicy policy) {
    request.knobs.shells.policy = policy;
    double largest = 0;
    Image last;
    for (int step = 0; step < 6; ++step) {
      request.camera.position = {0.02 * step, 0, 3 - 0.03 * step};
      const Image image = draw(*renderer, model, request);
      if (step > 0) largest = std::max(largest, mean_difference(image, last));
      last = image;
    }
    return largest;
  };
  EXPECT_LT(largest_change(ShellPolicy::adaptive), 1.25 * largest_change(ShellPolicy::uniform));
}

TEST_P(Frames, DenseFurHidesWhatLiesBehind) {
  const FurredModel model = furred({Builtin::sphere, 1000});
  FrameRequest request = shells_frame();
  const Image mask = draw(*renderer, model, request);
  request.background = Background::colour;
  request.background_colour = {1, 0, 0};
  const Image red = draw(*renderer, model, request);
  request.background_colour = {0, 1, 0};
  const Image green = draw(*renderer, model, request);
  for (std::size_t i = 0; i < mask.rgba.size(); i += 4) {
    if (mask.rgba[i + 3] < 255) continue;
    for (std::size_t k = 0; k < 3; ++k) ASSERT_NEAR(red.rgba[i + k], green.rgba[i + k], 1);
  }
  EXPECT_GT(covered(mask), 0.2);
}

TEST_P(Frames, LightIsAdditive) {
  FurredModel model = furred({Builtin::sphere, 1000});
  model.settings.look.ambient = 0;
  model.settings.look.self_shadow = 0;
  const Light left{.direction = {1, -0.3, -0.3}, .intensity = 0.25},
      right{.direction = {-1, -0.3, -0.3}, .intensity = 0.2};
  FrameRequest request = shells_frame();
  const auto linear_mean = [&](std::vector<Light> lights) {
    model.settings.lights = std::move(lights);
    const Image image = draw(*renderer, model, request);
    double sum = 0;
    for (std::size_t i = 0; i < image.rgba.size(); i += 4) {
      sum += image.rgba[i + 3] == 255 ? std::pow((image.rgba[i] / 255.0 + 0.055) / 1.055, 2.4) : 0;
    }
    return sum;
  };
  const double a = linear_mean({left}), b = linear_mean({right}), both = linear_mean({left, right}),
               dark = linear_mean({});
  EXPECT_GT(a, 10);
  EXPECT_NEAR(both - dark, a + b - 2 * dark, 0.03 * both);  // 8-bit steps and the toe of the curve
}

TEST_P(Frames, AmbientLightIsDarkenedOnce) {  // its floor is the share that reaches the roots, whatever lies above them
  FurredModel model = furred({Builtin::sphere, 1000});
  model.settings.lights.clear();
  model.settings.look.ambient_floor = 1;
  model.settings.look.self_shadow = 1;
  const Image shadowed = draw(*renderer, model, shells_frame());
  model.settings.look.self_shadow = 0;
  const Image unshadowed = draw(*renderer, model, shells_frame());
  for (std::size_t i = 0; i < unshadowed.rgba.size(); ++i) ASSERT_NEAR(shadowed.rgba[i], unshadowed.rgba[i], 1);
  model.settings.look.ambient_floor = 0;
  EXPECT_GT(mean_difference(unshadowed, draw(*renderer, model, shells_frame())), 1);
}

TEST_P(Frames, DirtyRangesSendOnlyThemselves) {
  FurredModel model = furred({Builtin::sphere, 1000});
  draw(*renderer, model, shells_frame());
  const UploadCount none = sync_shells(*renderer, model, {});
  EXPECT_EQ(none.bytes, 0u);
  Groom groom = model.fields.at(10);
  groom.length *= 3;
  model.fields.set(10, groom);
  const UploadCount some = sync_shells(*renderer, model, {{10, 11}});
  EXPECT_GT(some.bytes, 0u);
  EXPECT_LT(some.bytes, 200u);
}

TEST_P(Frames, CopiesAreCountedUntilTheyAreForgotten) {
  const FurredModel model = furred({Builtin::torus, 1000});
  const std::size_t before = renderer->gl_bytes();
  sync_shells(*renderer, model, {});
  const std::size_t sent = renderer->gl_bytes() - before, synced = renderer->bytes_of(model.model.id);
  EXPECT_GT(sent, 0u);
  EXPECT_GT(synced, sent);  // plus arrays on the CPU
  ASSERT_TRUE(renderer->draw(make_frame(model.view(), shells_frame())).ok());
  EXPECT_GT(renderer->bytes_of(model.model.id), synced);  // plus triangle lists of the view
  const std::size_t drawn = renderer->gl_bytes(), copy = renderer->bytes_of(model.model.id);
  renderer->forget(model.model.id);
  EXPECT_EQ(renderer->bytes_of(model.model.id), 0u);
  EXPECT_LT(renderer->gl_bytes(), drawn);
  EXPECT_GT(renderer->gl_bytes() + copy, drawn);
}

TEST_P(Frames, PartUploadEqualsAWholeOne) {
  FurredModel model = furred({Builtin::torus, 1000});
  draw(*renderer, model, shells_frame());
  for (std::uint32_t v = 100; v < 160; ++v) model.fields.set(v, {{0.6f, -0.6f}, 0.09f, 0});
  sync_shells(*renderer, model, {{100, 160}});
  const Image part = *renderer->draw(make_frame(model.view(), shells_frame()));
  renderer->forget(model.model.id);
  EXPECT_EQ(part.rgba, draw(*renderer, model, shells_frame()).rgba);
}

TEST_P(Frames, ExtremesGiveFinitePictures) {
  for (const double length : {0.0, 1e-6, 10.0}) {
    for (const double inclination : {0.0, 1.0}) {
      for (const int shells : {1, 2, 256}) {
        FurredModel model = furred({Builtin::sphere, 300}, {.length = length, .inclination = inclination});
        model.settings.lights = {{.kind = LightKind::point, .position = {0, 0, 0}, .intensity = 1e8}};
        model.settings.look.specular_exponent = 1e6;
        model.settings.look.diffuse_exponent = 0;
        FrameRequest request = shells_frame(AutoView::front, 24);
        request.knobs.shells.count = shells;
        request.background = Background::colour;
        const Image image = draw(*renderer, model, request);
        for (std::size_t i = 3; i < image.rgba.size(); i += 4) ASSERT_EQ(image.rgba[i], 255);  // a NaN would leave 0
      }
    }
  }
}

TEST_P(Frames, TuftsOpenGapsAndLeaveNoTraceInFramesWithoutThem) {
  FurredModel model = furred({Builtin::sphere, 1000}, {.length = 0.08, .inclination = 0.2});
  const Image before = draw(*renderer, model, shells_frame());
  model.settings.coats[0].coat.tufts = {.gather = 1, .size = 0.15, .scales = 1};
  const Image tufted = draw(*renderer, model, shells_frame());
  EXPECT_GT(mean_difference(before, tufted), 2);
  model.settings.coats[0].coat.tufts.seed = 2;
  EXPECT_GT(mean_difference(tufted, draw(*renderer, model, shells_frame())), 1);
  model.settings.coats[0].coat.tufts.gather = 0;
  EXPECT_EQ(draw(*renderer, model, shells_frame()).rgba, before.rgba);
}

TEST_P(Frames, WhatIsNotUsedCostsNothing) {
  // A scene without maps, pattern or environment costs what a program without those features would: skin, coarse depth
  // and fur; 4 shells of depth and 8 of fur on each side. The textures of model and coat are bound for skin and fur.
  FurredModel model = furred({Builtin::sphere, 300});
  model.settings.look.shading = ShadingModel::kajiya;  // needs no scattering table
  FrameRequest request = shells_frame();
  request.knobs.shells.count = 8;
  request.knobs.shells.policy = ShellPolicy::uniform;
  draw(*renderer, model, request);
  const auto counters = [&](const FurFrame& frame) { return counters_of(*renderer, frame); };
  FurFrame frame = make_frame(model.view(), request);
  const FrameCounters plain = counters(frame);
  EXPECT_EQ(plain.passes, 3u);
  EXPECT_EQ(plain.draws, 21u);
  EXPECT_EQ(plain.textures, 6u);
  EXPECT_EQ(plain.bytes, sizeof(FrameBlock) + 13312);  // shell LOD of each vertex, and triangle lists
  EXPECT_NEAR(static_cast<double>(plain.fragments), 89599, 0.05 * 89599);  // edges differ between drivers
  EXPECT_EQ(counters(frame), plain);

  frame.lights[0].self_shadow_maps = true;  // asked for by the light alone, so no map is drawn
  EXPECT_EQ(counters(frame), plain);
  frame.knobs.shells.shadow_maps = true;
  EXPECT_GT(counters(frame).draws, plain.draws);
  frame.knobs.shells.shadow_maps = false;  // maps that were drawn once cost later frames nothing
  EXPECT_EQ(counters(frame), plain);
}

TEST_P(Frames, SizesFromOnePixelOn) {
  const FurredModel model = furred({Builtin::sphere, 300});
  for (const auto& [width, height] : {std::pair{1, 1}, {7, 300}, {300, 7}}) {
    FrameRequest request = shells_frame();
    request.width = width, request.height = height;
    const Image image = draw(*renderer, model, request);
    EXPECT_EQ(image.rgba.size(), static_cast<std::size_t>(4 * width * height));
  }
}

TEST_P(Frames, TheUprightPoleIsUp) {  // rows come from the top: a light from above brightens the upper half
  // Lying fur, since upright fur at the pole would point at the light and reflect nothing (Kajiya).
  FurredModel model = furred({Builtin::sphere, 1000}, {.inclination = 0.95});
  model.settings.lights = {{.direction = {0, -1, 0}}};
  const Image image = draw(*renderer, model, shells_frame());
  double upper = 0, lower = 0;
  for (int y = 0; y < image.height; ++y) {
    for (int x = 0; x < image.width; ++x) {
      const std::size_t i = 4 * static_cast<std::size_t>(y * image.width + x);
      (y < image.height / 2 ? upper : lower) += image.rgba[i + 3] == 255 ? image.rgba[i] : 0;
    }
  }
  EXPECT_GT(upper, lower * 1.2);
}

INSTANTIATE_TEST_SUITE_P(Gl, Frames, all_contexts(), name_of);

TEST(Backends, GiveTheSameBytesOnOneMesa) {
  const FurredModel model = furred({Builtin::creature, 2000});
  std::vector<std::vector<std::uint8_t>> pictures;
  for (const Backend backend : {Backend::egl_device, Backend::egl_surfaceless, Backend::osmesa}) {
    const Result<Context*> context = stage.context(backend);
    if (!context && !in_ci()) GTEST_SKIP() << context.status().message;
    ASSERT_TRUE(context.ok()) << context.status().message;
    const std::string& driver = (*context)->description();
    const bool software = driver.find("llvmpipe") != std::string::npos || driver.find("softpipe") != std::string::npos;
    if (!software) GTEST_SKIP() << "a hardware driver draws other bits: " << driver;
    const Result<Renderer*> renderer = stage.renderer(backend);
    ASSERT_TRUE(renderer.ok()) << renderer.status().message;
    pictures.push_back(draw(**renderer, model, shells_frame(AutoView::three_quarter, 200)).rgba);
  }
  EXPECT_EQ(pictures[0], pictures[1]);
  EXPECT_EQ(pictures[0], pictures[2]);
}

}  // namespace
}  // namespace pelage::testing::renderer_test
