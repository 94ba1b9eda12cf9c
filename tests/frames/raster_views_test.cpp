// After a stroke only the dirty region of a rasterized picture is drawn again, with the bits of a whole frame.
#include "tests/frames/raster_views.h"

#include <algorithm>
#include <array>

namespace pelage::testing::raster_views_test {
namespace {

TEST_F(RasterViews, AStrokeDrawsItsPartWithTheBitsOfAWholeFrame) {
  FurredModel model = animal();
  for (const double scale : {1.0, 0.6}) {
    request.knobs.scale = scale;
    EXPECT_LT(expect_same_bits(model, 5), 0.7);
    expect_grown_at_once(model);
  }
  request.knobs.scale = 1, request.knobs.raster = {.strands = 1000, .light_of = 1};
  EXPECT_LT(expect_same_bits(model), 0.7);
  model.settings.coats[0].coat.variation = {.length = 1, .lean = 1};
  model.settings.coats[0].coat.guard_hairs = 100;
  expect_same_bits(model);
}

TEST_F(RasterViews, ADraftGrowsAShareOfTheCoatAndAStrokeDrawsItsPart) {
  FurredModel model = animal();
  model.settings.coats[0].coat = Coat();  // so dense that a draft grows a share of it
  request.width = request.height = 128;
  request.knobs = knobs_of(Tier::draft);
  expect_same_bits(model, 2);
  expect_grown_at_once(model);
  const std::size_t of_draft = raster.bytes_of(model.model.id);
  request.knobs = knobs_of(Tier::interactive);
  drawn(model);
  EXPECT_GT(raster.bytes_of(model.model.id), 2 * of_draft);
}

TEST_F(RasterViews, WithoutGroundAndFromAnywhere) {
  FurredModel model = animal();
  model.settings.ground.visible = false;
  for (const glm::ivec2 size : {glm::ivec2(3, 100), glm::ivec2(97, 131), glm::ivec2(500, 400)}) {
    request.width = size.x, request.height = size.y;
    expect_same_bits(model);
  }
  request.camera.automatic = AutoView::none;
  request.camera.position = {0.05, 0.25, 0.6}, request.camera.target = {0.02, 0.16, 0.27};  // strands many pixels wide
  expect_same_bits(model);
  request.camera.fov_degrees = 10;  // so near that single strands cast shadows
  expect_same_bits(model);
  request.camera.fov_degrees = 35;
  request.camera.position = {0.02, 0.1, 0.3}, request.camera.target = {0, 0, 0};  // inside the fur
  expect_same_bits(model);
}

// A stroke redraws little if its light neither comes into view nor lies near the camera.
TEST_F(RasterViews, AStrokeBehindTheCameraOrBesideItDrawsLittle) {
  FurredModel model = furred({Builtin::creature, 20000});
  model.settings.ground.visible = false;
  const Mesh& mesh = model.model.surface.mesh();
  const glm::dvec3 camera(0, 0.3, 0), direction = glm::normalize(glm::dvec3(0, -0.5, 1));
  request.camera.automatic = AutoView::none, request.camera.fov_degrees = 60;
  request.camera.position = camera * mesh.size + mesh.centre;
  request.camera.target = (camera + direction) * mesh.size + mesh.centre;
  drawn(model);
  int changed = 0, little = 0;
  for (std::uint32_t v = 0; v < mesh.positions.size() && changed < 12; v += 97) {
    const glm::dvec3 apart = glm::dvec3(mesh.positions[v]) - camera;
    const double forward = glm::dot(apart, direction), aside = glm::length(apart - forward * direction);
    if (forward > 0.02 || aside < 0.1) continue;
    model.fields.set(Field::direction, v, {0.5f, 0.3f, 0, 0});
    const Drawn part = drawn(model, {{v, v + 1}});
    EXPECT_EQ(part.image.rgba, whole(model).rgba) << forward << " " << aside;
    ++changed, little += part.redrawn < 0.05 ? 1 : 0;
  }
  EXPECT_EQ(changed, 12);
  EXPECT_GE(little, 4);
}

// Near cells that are far apart may share an entry of the hash table, so a change may alter the picture anywhere.
TEST_F(RasterViews, WhatIsNearIsDrawnWholeWhenAnyOfItChanges) {
  FurredModel model = furred({Builtin::creature, 20000});
  const Mesh& mesh = model.model.surface.mesh();
  const glm::dvec3 camera(0, 0.3, 0);
  request.camera.automatic = AutoView::none, request.camera.fov_degrees = 20;
  request.camera.position = camera * mesh.size + mesh.centre;
  request.camera.target = (camera + glm::dvec3(0, -0.5, 1)) * mesh.size + mesh.centre;
  drawn(model);
  for (std::uint32_t v = 0; v < 4000; v += 97) {
    model.fields.set(Field::direction, v, {0.5f, 0.3f, 0, 0});
    const Drawn part = drawn(model, {{v, v + 1}});
    EXPECT_EQ(part.image.rgba, whole(model).rgba) << v << ", " << part.redrawn;
  }
}

TEST_F(RasterViews, FurThatWasLongIsTakenAway) {
  FurredModel model = coarse(furred({Builtin::sphere, 2000}, {.length = 0.01}));
  const auto drawn_with = [&](float length) {
    for (std::uint32_t v = 0; v < 4; ++v) model.fields.set(Field::length, v, {length, 0, 0, 0});
    return drawn(model, {{0, 4}});
  };
  for (const float length : {0.12f, 0.01f, 0.12f}) drawn_with(length);
  const Image part = drawn_with(0.01f).image;
  EXPECT_EQ(part.rgba, whole(model).rgba);
}

TEST_F(RasterViews, TheSameAgainDrawsNothing) {
  FurredModel model = animal();
  for (const bool ground : {true, false}) {
    model.settings.ground.visible = ground;
    const Drawn first = drawn(model), again = drawn(model);
    EXPECT_EQ(again.redrawn, 0);
    EXPECT_EQ(first.image.rgba, again.image.rgba);
    request.exposure += 1;  // is applied after the light
    const Drawn lighter = drawn(model);
    EXPECT_EQ(lighter.redrawn, 0);
    EXPECT_NE(lighter.image.rgba, first.image.rgba);
  }
}

TEST_F(RasterViews, CurvesThatMoveAreDrawnAgain) {
  FurredModel model = animal();
  request.width = request.height = 400;
  drawn(model);
  model.settings.curves[0].curves[1][2] += glm::dvec3(0.05, 0.02, 0);
  const Drawn again = drawn(model);
  EXPECT_EQ(again.redrawn, 1);
  EXPECT_EQ(again.image.rgba, whole(model).rgba);
}

TEST_F(RasterViews, AnotherPictureBetweenIsNotMistakenForIt) {
  FurredModel model = animal(), other = animal();
  for (int i = 0; i < 6; ++i) drawn(model, stroke(model));  // until the hull of the fur has its full extent
  const auto expect_part = [&] {
    const Drawn part = drawn(model, stroke(model));
    EXPECT_LT(part.redrawn, 1);
    EXPECT_EQ(part.image.rgba, whole(model).rgba);
  };
  expect_part();
  DrawTimes times;
  ASSERT_TRUE(raster.draw_deep(frame_of(model, stroke(model)), nullptr, times, {}).ok());
  expect_part();
  ASSERT_TRUE(raster.draw_aovs(frame_of(model, stroke(model)), std::array{Aov::beauty}, times, {}).ok());
  expect_part();
  drawn(other, stroke(other));
  expect_part();
  model.settings.lights.resize(1);
  EXPECT_EQ(drawn(model, stroke(model)).redrawn, 1) << "other light";
  expect_part();
  model.settings.coats[0].coat.count /= 2;
  EXPECT_EQ(drawn(model, stroke(model)).redrawn, 1) << "another coat";
  expect_part();
}

TEST_F(RasterViews, SkinThatIsPaintedIsDrawnAgain) {
  FurredModel model = coarse(furred({Builtin::sphere, 2000}, {.length = 0}));
  request.camera.automatic = AutoView::front;
  const auto painted = [&](Field field, std::uint32_t from) {
    std::vector<DirtyRange> dirty;
    const Mesh& mesh = model.model.surface.mesh();
    for (std::uint32_t v = from; v < mesh.positions.size(); v += 7)
      if (mesh.positions[v].z > 0.22f) model.fields.set(field, v, {1, 0, 0, 0}), dirty.push_back({v, v + 1});
    return drawn(model, dirty);
  };
  painted(Field::bare, 0), painted(Field::wetness, 0);
  const Drawn part = painted(Field::bare, 1);
  EXPECT_GT(part.redrawn, 0);
  EXPECT_LT(part.redrawn, 0.9);
  EXPECT_EQ(part.image.rgba, whole(model).rgba);
}

/// Share of the pixels where `where` holds on which the overlay shows a field.
template <class Where>
double shown_share(const FloatImage& overlay, const Where& where) {
  double shown = 0, all = 0;
  for (std::size_t i = 0; i < overlay.rgba.size() / 4; ++i) {
    if (!where(i)) continue;
    all += 1, shown += overlay.rgba[4 * i + 3] > 0.2f ? 1 : 0;
  }
  return shown / std::max(all, 1.0);
}

TEST_F(RasterViews, FieldsAreShownOnTheFurAndNotOnlyOnItsSkin) {
  FurredModel model = coarse(furred({Builtin::sphere, 2000}, {.length = 0.12}));
  model.settings.ground.visible = false;
  request.overlay = Overlay::length;
  const Image fur = drawn(model).image;
  const auto over = [&] {
    DrawTimes times;
    return raster.field_overlay(frame_of(model, {{0, static_cast<std::uint32_t>(model.fields.size())}}), times, {})
        .value();
  };
  const FloatImage overlay = over();
  EXPECT_GT(shown_share(overlay, [&](std::size_t i) { return fur.rgba[4 * i + 3] > 200; }), 0.99);
  EXPECT_EQ(shown_share(overlay, [&](std::size_t i) { return fur.rgba[4 * i + 3] == 0; }), 0);
}

TEST_F(RasterViews, AnotherFieldInThePauseIsNotMistakenForIt) {
  const FurredModel model = coarse(furred({Builtin::sphere, 500}, {.length = 0.05}));
  request.camera.automatic = AutoView::none, request.camera.position = {0, 0, 0.8}, request.camera.target = {0, 0, 0};
  request.width = 1100, request.height = 1100, request.overlay = Overlay::direction;
  const FurFrame frame = frame_of(model);
  FurFrame other = frame;
  other.overlay = Overlay::density, other.width = other.height = 64;
  DrawTimes times;
  int pauses = 0;
  const auto between = [&] { return ++pauses > 0 && raster.field_overlay(other, times, {}).ok(); };
  const FloatImage alone = raster.field_overlay(frame, times, {}).value();
  EXPECT_EQ(raster.field_overlay(frame, times, between).value().rgba, alone.rgba);
  EXPECT_GT(pauses, 0);
}

}  // namespace
}  // namespace pelage::testing::raster_views_test
