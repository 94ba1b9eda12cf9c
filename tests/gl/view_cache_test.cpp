// After a stroke only the part of the picture that it may touch is drawn, with the bits of a whole frame.
#include <algorithm>
#include <array>
#include <cmath>
#include <random>

#include "server/frames/fur_view.h"
#include "tests/gl/with_renderer.h"
#include "tests/support/furred_model.h"

namespace pelage::testing {
namespace {

struct Drawn {
  Image image;
  double redrawn = 0;  // share of the picture
};

class ViewCacheTest : public WithRenderer {
 protected:
  Drawn drawn(const FurredModel& model, const std::vector<VertexRange>& dirty) {
    sync_scene(*renderer, model.view(), dirty);
    DrawTimes times;
    Result<Image> image = renderer->draw(make_frame(model.view(), request), &times);
    EXPECT_TRUE(image.ok()) << image.status().message;
    return {std::move(image).value(), times.counters.redrawn};
  }

  /// Draws after each of some strokes, and once more whole; gives the shares of the picture that strokes drew.
  std::vector<double> expect_same_bits(FurredModel&& model, int strokes = 6) {
    return expect_same_bits(model, strokes);
  }
  std::vector<double> expect_same_bits(FurredModel& model, int strokes = 6) {
    drawn(model, {});
    std::vector<double> shares;
    for (int i = 0; i < strokes; ++i) {
      const std::vector<VertexRange> dirty = stroke(model);
      const Drawn part = drawn(model, dirty);
      renderer->clear_view_cache();
      const Drawn whole = drawn(model, {});
      EXPECT_EQ(whole.redrawn, 1);
      EXPECT_EQ(part.image.rgba, whole.image.rgba) << "stroke " << i << ", " << part.redrawn << " of the picture";
      shares.push_back(part.redrawn);
    }
    return shares;
  }

  /// Other fur around a vertex.
  std::vector<VertexRange> stroke(FurredModel& model) {
    const Mesh& mesh = model.model.surface.mesh();
    const FieldSet before = model.fields;
    const auto any = [&](float high) { return std::uniform_real_distribution<float>(0, high)(random_); };
    const glm::vec3 middle = mesh.positions[random_() % mesh.positions.size()];
    for (std::uint32_t v = 0; v < mesh.positions.size(); ++v) {
      if (glm::distance(mesh.positions[v], middle) > 0.1f) continue;
      model.fields.set(Field::direction, v, {any(0.7f), any(0.7f), 0, 0});
      model.fields.set(Field::length, v, {any(0.12f), 0, 0, 0});
      if (painted) model.fields.set(Field::tip_colour, v, {any(1), any(1), any(1), 1});
      if (painted) model.fields.set(Field::density, v, {any(1), 0, 0, 0});
    }
    return difference(before, model.fields).dirty_ranges();
  }

  FrameRequest request = small_frame();
  bool painted = false;

 private:
  std::mt19937 random_{7};
};

FurredModel animal() { return furred({Builtin::creature, 2000}); }

TEST_P(ViewCacheTest, AStrokeDrawsItsPart) {
  for (const double share : expect_same_bits(animal())) EXPECT_LT(share, 0.7);
  EXPECT_LT(expect_same_bits(animal(), 1).front(), 0.7);  // another model: nothing of it is kept
}

TEST_P(ViewCacheTest, FurThatWasLongIsTakenAway) {
  FurredModel model = furred({Builtin::sphere, 2000}, {.length = 0.01});
  const VertexRange some{0, 4};
  const auto drawn_with = [&](float length) {
    for (std::uint32_t v = some.begin; v < some.end; ++v) model.fields.set(Field::length, v, {length, 0, 0, 0});
    return drawn(model, {some});
  };
  drawn_with(0.12f);
  const Drawn part = drawn_with(0.01f);
  EXPECT_LT(part.redrawn, 1);
  renderer->clear_view_cache();
  EXPECT_EQ(part.image.rgba, drawn(model, {}).image.rgba);
}

TEST_P(ViewCacheTest, WithEveryKnobThatKeepsChangesNear) {
  request.knobs.scale = 0.6;
  expect_same_bits(animal());
  request.knobs.scale = 1, request.knobs.shells = 32, request.knobs.shell_policy = ShellPolicy::adaptive;
  expect_same_bits(animal());
}

TEST_P(ViewCacheTest, WithGroundEyesVariationAndPaint) {
  FurredModel model = animal();
  model.settings.ground.visible = true;
  model.settings.coat.variation = {.length = 1, .lean = 1};
  model.settings.eyes = {Eye{}};
  painted = true;
  expect_same_bits(model);
}

TEST_P(ViewCacheTest, WithCurvesThatStandInTheFur) {
  FurredModel model = animal();
  for (const double spread : {0.0, 1.0}) {
    CurveGroup group;
    group.width_root = 0.01, group.fill = 5, group.spread = spread;
    for (std::size_t v = 0; v < 200; v += 40) {
      const Mesh& mesh = model.model.surface.mesh();
      const glm::dvec3 root = glm::dvec3(mesh.positions[v]) * mesh.size + mesh.centre,
                       way = glm::dvec3(mesh.normals[v]) * mesh.size;
      group.curves.push_back({root, root + 0.03 * way, root + 0.04 * way + glm::dvec3(0.2, 0, 0.1) * mesh.size});
    }
    model.settings.curves.push_back(group);
  }
  const std::vector<double> shares = expect_same_bits(model, 8);
  EXPECT_LT(*std::min_element(shares.begin(), shares.end()), 0.7);
}

TEST_P(ViewCacheTest, OfAnySizeAndFromAnywhere) {
  for (const glm::ivec2 size : {glm::ivec2(3, 100), glm::ivec2(97, 131)}) {
    request.width = size.x, request.height = size.y;
    expect_same_bits(animal(), 3);
  }
  request.camera.automatic = AutoView::none;
  request.camera.position = {0.02, 0.1, 0.3}, request.camera.target = {0, 0, 0};  // inside the fur
  expect_same_bits(animal(), 3);
}

TEST_P(ViewCacheTest, WhatReachesFurtherIsDrawnWhole) {
  FurredModel model = animal();
  const auto share = [&] { return expect_same_bits(model, 1).front(); };
  request.knobs.fins = true;
  EXPECT_EQ(share(), 1);
  request.knobs.fins = false, request.knobs.guard_hairs = 100;
  EXPECT_EQ(share(), 1);
  request.knobs.guard_hairs = 0, request.knobs.order = FragmentOrder::sorted;
  EXPECT_EQ(share(), 1);
  request.knobs.order = FragmentOrder::shells, request.overlay = Overlay::direction;
  EXPECT_EQ(share(), 1);
  request.overlay = Overlay::none, request.knobs.shadow_maps = true;
  Light light;
  light.self_shadow_maps = true;
  model.settings.lights = {light};
  EXPECT_EQ(share(), 1);
}

TEST_P(ViewCacheTest, AnotherFrameBetweenIsNotMistakenForIt) {
  FurredModel model = animal();
  drawn(model, {});
  const FloatImage other{request.width, request.height, std::vector<float>(4 * 128 * 128, 0.5f)};
  ASSERT_TRUE(renderer->finish(make_frame(model.view(), request), other).ok());  // a traced picture in between
  const auto expect_part = [&] {
    const Drawn part = drawn(model, stroke(model));
    EXPECT_LT(part.redrawn, 1);
    renderer->clear_view_cache();
    EXPECT_EQ(part.image.rgba, drawn(model, {}).image.rgba);
  };
  expect_part();
  request.exposure = 1;  // comes after the light
  expect_part();
  ASSERT_TRUE(renderer->draw_backplate(make_frame(model.view(), request)).ok());
  expect_part();
  ASSERT_TRUE(
      renderer->draw_aovs(make_frame(model.view(), request), std::array{Aov::beauty}).ok());  // into its targets
  EXPECT_EQ(drawn(model, {}).redrawn, 1);
  expect_part();
  model.settings.look.ambient = 1;
  EXPECT_EQ(drawn(model, stroke(model)).redrawn, 1);
}

// Each view knows what has changed since it was drawn itself.
TEST_P(ViewCacheTest, SeveralViewsAreCached) {
  FurredModel model = animal();
  const std::array views{AutoView::front, AutoView::left, AutoView::top};
  const auto from = [&](AutoView view, const std::vector<VertexRange>& changed) {
    request.camera.automatic = view;
    return drawn(model, changed);
  };
  for (const AutoView view : views) EXPECT_EQ(from(view, stroke(model)).redrawn, 1);
  for (int round = 0; round < 3; ++round) {
    for (const AutoView view : views) EXPECT_LT(from(view, stroke(model)).redrawn, 1);
  }
  std::vector<Image> kept;
  for (const AutoView view : views) kept.push_back(from(view, {}).image);
  renderer->clear_view_cache();
  for (std::size_t i = 0; i < views.size(); ++i) EXPECT_EQ(kept[i].rgba, from(views[i], {}).image.rgba) << i;
}

TEST_P(ViewCacheTest, SeveralScenesAreCached) {
  FurredModel one = animal(), other = animal();
  for (FurredModel* model : {&one, &other}) EXPECT_EQ(drawn(*model, {}).redrawn, 1);
  for (int round = 0; round < 3; ++round) {
    for (FurredModel* model : {&one, &other}) {
      const Drawn part = drawn(*model, stroke(*model));
      EXPECT_LT(part.redrawn, 1);
      EXPECT_EQ(drawn(*model, {}).redrawn, 0);
    }
  }
  const Image kept = drawn(one, {}).image;
  renderer->clear_view_cache();
  EXPECT_EQ(kept.rgba, drawn(one, {}).image.rgba);
}

// An orbit's frames are not asked for again: they do not push out who grooms beside it.
TEST_P(ViewCacheTest, AnOrbitLeavesWhatComesBack) {
  FurredModel model = animal();
  const auto orbit = [&](int frame) {
    FrameRequest turned = request;
    turned.camera.automatic = AutoView::none;
    turned.camera.position = {2 * std::sin(0.1 * frame), 0, 2 * std::cos(0.1 * frame)},
    turned.camera.target = {0, 0, 0};
    ASSERT_TRUE(renderer->draw(make_frame(model.view(), turned)).ok());
  };
  drawn(model, {});
  drawn(model, stroke(model));
  for (int frame = 0; frame < 6; ++frame) orbit(frame);
  EXPECT_LT(drawn(model, stroke(model)).redrawn, 1);
  drawn(model, {});
  request.width = request.height = 2100;  // more than is kept at all
  EXPECT_EQ(drawn(model, {}).redrawn, 1);
  EXPECT_EQ(drawn(model, {}).redrawn, 1);
  request.width = request.height = 128;
  EXPECT_EQ(drawn(model, {}).redrawn, 0);
}

INSTANTIATE_TEST_SUITE_P(Gl, ViewCacheTest, both_backends(), name_of);

}  // namespace
}  // namespace pelage::testing
