// After a stroke only the part of a marched picture that it may touch is drawn, with the bits of a whole frame.
#include "renderer/frame/view_cache.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "tests/gl/marched_frames.h"

namespace pelage::testing::view_cache_test {
namespace {

using CachedViews = MarchedFrames;

TEST_F(CachedViews, AStrokeDrawsItsPartWithTheBitsOfAWholeFrame) {
  FurredModel model = animal();
  for (const double scale : {1.0, 0.6}) {
    request.knobs.scale = scale;
    EXPECT_LT(expect_same_bits(model, 5), 0.7);
  }
  request.knobs.scale = 1, request.knobs.shells = 32, request.knobs.shell_policy = ShellPolicy::adaptive;
  EXPECT_LT(expect_same_bits(model), 0.7);
  model.settings.coat.variation = {.length = 1, .lean = 1};
  expect_same_bits(model);
}

TEST_F(CachedViews, FurThatWasLongIsTakenAway) {
  FurredModel model = furred({Builtin::sphere, 2000}, {.length = 0.01});
  const auto drawn_with = [&](float length) {
    for (std::uint32_t v = 0; v < 4; ++v) model.fields.set(Field::length, v, {length, 0, 0, 0});
    return drawn(model, {{0, 4}});
  };
  // The first time the longest fur of all grows, which is drawn whole.
  for (const float length : {0.12f, 0.01f, 0.12f}) drawn_with(length);
  const Image part = drawn_with(0.01f).image;
  EXPECT_EQ(part.rgba, whole(model).rgba);
}

TEST_F(CachedViews, OfAnySizeAndFromAnywhere) {
  FurredModel model = animal();
  for (const glm::ivec2 size : {glm::ivec2(3, 100), glm::ivec2(97, 131)}) {
    request.width = size.x, request.height = size.y;
    expect_same_bits(model);
  }
  request.camera.automatic = AutoView::none;
  request.camera.position = {0.02, 0.1, 0.3}, request.camera.target = {0, 0, 0};  // inside the fur
  expect_same_bits(model);
}

TEST_F(CachedViews, WhatReachesFurtherIsDrawnWhole) {
  FurredModel model = animal();
  request.knobs.guard_hairs = 100;
  EXPECT_EQ(expect_same_bits(model, 1), 1);
  request.knobs.guard_hairs = 0, request.knobs.shadow_maps = true;
  model.settings.lights = {Light{.cast_shadow = CastShadow::penumbra}};
  EXPECT_EQ(expect_same_bits(model, 1), 1);
}

TEST_F(CachedViews, TheSameAgainDrawsNothing) {
  const FurredModel model = animal();
  const Drawn first = drawn(model), again = drawn(model);
  EXPECT_EQ(again.redrawn, 0);
  EXPECT_EQ(first.image.rgba, again.image.rgba);
  request.exposure = 1;  // comes after the light
  const Drawn lighter = drawn(model);
  EXPECT_EQ(lighter.redrawn, 0);
  EXPECT_NE(lighter.image.rgba, first.image.rgba);
}

TEST_F(CachedViews, AnotherPictureBetweenIsNotMistakenForIt) {
  FurredModel model = animal();
  drawn(model, stroke(model));
  const auto expect_part = [&] {
    const Drawn part = drawn(model, stroke(model));
    EXPECT_LT(part.redrawn, 1);
    EXPECT_EQ(part.image.rgba, whole(model).rgba);
  };
  expect_part();
  ASSERT_TRUE(marched.draw_deep(frame_of(model, stroke(model)), nullptr, {}).ok());
  expect_part();
  ASSERT_TRUE(marched.draw_aovs(frame_of(model, stroke(model)), std::array{Aov::beauty}, nullptr, {}).ok());
  expect_part();
  model.settings.look.ambient = 1;
  EXPECT_EQ(drawn(model, stroke(model)).redrawn, 1);
}

// Each view knows what has changed since it was drawn itself.
TEST_F(CachedViews, SeveralAreCached) {
  FurredModel model = animal();
  const std::array views{AutoView::front, AutoView::left, AutoView::top};
  const auto from = [&](AutoView view, const std::vector<DirtyRange>& changed) {
    request.camera.automatic = view;
    return drawn(model, changed);
  };
  drawn(model, stroke(model));
  for (const AutoView view : views) EXPECT_EQ(from(view, stroke(model)).redrawn, 1);
  for (const AutoView view : views) EXPECT_LT(from(view, stroke(model)).redrawn, 1);
  std::vector<Image> kept;
  for (const AutoView view : views) kept.push_back(from(view, {}).image);
  marched.clear_view_cache();
  for (std::size_t i = 0; i < views.size(); ++i) EXPECT_EQ(kept[i].rgba, from(views[i], {}).image.rgba) << i;
}

TEST_F(CachedViews, OfSeveralScenes) {
  FurredModel one = animal(), other = animal();
  for (FurredModel* model : {&one, &other}) drawn(*model, stroke(*model));
  for (FurredModel* model : {&one, &other}) {
    EXPECT_LT(drawn(*model, stroke(*model)).redrawn, 1);
    EXPECT_EQ(drawn(*model).redrawn, 0);
  }
  const Image kept = drawn(one).image;
  EXPECT_EQ(kept.rgba, whole(one).rgba);
}

// An orbit's frames are not asked for again: they do not push out who grooms beside it.
TEST_F(CachedViews, AnOrbitLeavesWhatComesBack) {
  FurredModel model = animal();
  const FrameRequest groomed = request;
  drawn(model, stroke(model));
  drawn(model, stroke(model));
  for (int frame = 0; frame < 6; ++frame) {
    request.camera.automatic = AutoView::none;
    request.camera.position = {2 * std::sin(0.1 * frame), 0, 2 * std::cos(0.1 * frame)};
    request.camera.target = {0, 0, 0};
    drawn(model);
  }
  request = groomed;
  EXPECT_LT(drawn(model, stroke(model)).redrawn, 1);
  request.width = request.height = 2100;  // more than is kept at all
  EXPECT_EQ(drawn(model).redrawn, 1);
  EXPECT_EQ(drawn(model).redrawn, 1);
  request = groomed;
  EXPECT_EQ(drawn(model).redrawn, 0);
}

}  // namespace
}  // namespace pelage::testing::view_cache_test
