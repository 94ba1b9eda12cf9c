// Painted fields in whole frames.
#include <algorithm>
#include <cmath>

#include "server/frames/fur_view.h"
#include "tests/frames/with_renderer.h"
#include "tests/support/furred_model.h"

namespace pelage::testing::paint_test {
namespace {

class PaintedFrames : public WithRenderer {
 protected:
  Image drawn(const FurredModel& model) { return draw(*renderer, model, request); }
  FrameRequest request = small_frame();
};

FurredModel ball(double fur = 0.08, int triangles = 2000) {
  return coarse(furred({Builtin::sphere, triangles}, {.length = fur, .inclination = 0.3}));
}

/// Sets a field at the vertices whose positions `where` accepts.
template <class Where>
void paint(FurredModel& model, Field field, glm::vec4 value, Where where) {
  const Mesh& mesh = model.model.surface.mesh();
  for (std::uint32_t v = 0; v < mesh.positions.size(); ++v) {
    if (where(mesh.positions[v])) model.fields.set(field, v, value);
  }
}

bool all_over(glm::vec3) { return true; }
bool on_the_right(glm::vec3 position) { return position.x > 0; }

void flood(FurredModel& model, Field field, glm::vec4 value) { paint(model, field, value, all_over); }
void flood(FurredModel& model, Field field, float value) { flood(model, field, glm::vec4(value, 0, 0, 0)); }

double sum_of_alpha(const Image& image) {
  double sum = 0;
  for (std::size_t i = 3; i < image.rgba.size(); i += 4) sum += image.rgba[i];
  return sum / 255;
}

double lightness(const Image& image) { return glm::dot(mean_colour(image), glm::dvec3(1.0 / 3)); }

/// Mean colour of a square about a point that is given in shares of the picture.
glm::dvec3 colour_at(const Image& image, glm::dvec2 position, int reach = 6) {
  glm::dvec3 sum(0);
  const glm::ivec2 middle(position * glm::dvec2(image.width, image.height));
  for (int y = middle.y - reach; y < middle.y + reach; ++y) {
    for (int x = middle.x - reach; x < middle.x + reach; ++x) {
      const std::size_t i = 4 * static_cast<std::size_t>(y * image.width + x);
      sum += glm::dvec3(image.rgba[i], image.rgba[i + 1], image.rgba[i + 2]);
    }
  }
  return sum / (4.0 * reach * reach);
}

TEST_F(PaintedFrames, FieldsSetBackToTheirDefaultsGiveTheSamePicture) {
  FurredModel model = ball();
  model.settings.coats[0].coat.guard_hairs = 2000;
  const Image before = drawn(model);
  for (std::size_t i = first_painted; i < field_count; ++i) {  // changed, then set back to the default
    const float default_value = field_shapes[i].default_value;
    flood(model, field_at(i), glm::vec4(field_shapes[i].channels == 1 ? default_value * 0.5f + 0.25f : 0.5f));
    flood(model, field_at(i), field_shapes[i].channels == 1 ? glm::vec4(default_value, 0, 0, 0) : glm::vec4(0));
  }
  ASSERT_FALSE(model.fields.at_default(Field::clump));
  const Image after = drawn(model);
  EXPECT_LE(largest_difference(before, after), 1) << "rounding of what is drawn by other programs";
  EXPECT_LT(mean_difference(before, after), 0.01);
}

TEST_F(PaintedFrames, LeaveNoTraceInOtherScenes) {
  FurredModel model = ball(), other = ball();
  const Image before = drawn(other);
  flood(model, Field::density, 0.3f);
  flood(model, Field::tip_colour, glm::vec4(1, 0, 0, 1));
  drawn(model);
  EXPECT_EQ(drawn(other).rgba, before.rgba);
}

TEST_F(PaintedFrames, DensityTakesStrandsAway) {
  FurredModel model = ball();
  const double whole = sum_of_alpha(drawn(model));
  flood(model, Field::density, 0.3f);
  const double some = sum_of_alpha(drawn(model));
  flood(model, Field::density, 0.0f);
  const Image none = drawn(model);
  EXPECT_LT(some, 0.99 * whole);  // fewer at the rim alone: the skin below is opaque
  EXPECT_LT(sum_of_alpha(none), 0.97 * some);
  EXPECT_NEAR(sum_of_alpha(none), sum_of_alpha(drawn(ball(0))), 1) << "the ball alone";
  EXPECT_LE(largest_difference(none, drawn(ball(0))), 1);
}

TEST_F(PaintedFrames, WhatDensityLeavesIsWhole) {
  // White fur over dark roots and skin, seen closely from above: kept strands are as bright as before, gaps show skin.
  FurredModel model = coarse(furred({Builtin::plane, 200}, {.length = 0.02, .inclination = 0.2}));
  model.settings.coats[0].coat.ramp = {{0, {0, 0, 0}}, {0.1, {1, 1, 1}}};
  model.settings.coats[0].coat.colour_spread = 0, model.settings.coats[0].coat.clump = 0;
  Look& look = model.settings.look;
  look.skin = glm::vec3(0), look.ambient = 0.6, look.ambient_floor = 1, look.diffuse = look.specular = 0;
  request = small_frame(AutoView::none, 256);
  request.camera.position = {0.02, 0.25, 0.03}, request.camera.target = {0.02, 0, 0.02};
  request.camera.fov_degrees = 12;
  const auto share_of = [&](int min, int max) {
    const Image image = drawn(model);
    double count = 0;
    for (std::size_t i = 0; i < image.rgba.size(); i += 4) count += image.rgba[i] >= min && image.rgba[i] <= max;
    return 4 * count / static_cast<double>(image.rgba.size());
  };
  const int bright = 180, dark = 60;
  EXPECT_GT(share_of(bright, 255), 0.8);
  flood(model, Field::density, 0.12f);
  EXPECT_GT(share_of(bright, 255), 0.1);
  EXPECT_GT(share_of(0, dark), 0.2) << "dimmed instead of thinned";
}

TEST_F(PaintedFrames, WidthCoversMoreOrLess) {
  FurredModel model = ball();
  model.settings.coats[0].coat.count = 1500;
  const double whole = sum_of_alpha(drawn(model));
  flood(model, Field::width, 0.3f);
  EXPECT_LT(sum_of_alpha(drawn(model)), 0.98 * whole);
  flood(model, Field::width, 3.0f);
  EXPECT_GT(sum_of_alpha(drawn(model)), 1.01 * whole);
}

TEST_F(PaintedFrames, ColoursCoverTheCoats) {
  FurredModel model = ball();
  const glm::dvec3 plain = mean_colour(drawn(model));
  EXPECT_GT(plain.r, plain.b);
  flood(model, Field::tip_colour, glm::vec4(0, 0, 0.8f, 0.5f));
  const glm::dvec3 half = mean_colour(drawn(model));
  flood(model, Field::root_colour, glm::vec4(0, 0, 0.8f, 1));
  flood(model, Field::tip_colour, glm::vec4(0, 0, 0.8f, 1));
  const glm::dvec3 blue = mean_colour(drawn(model));
  EXPECT_GT(half.b - half.r, plain.b - plain.r + 10);
  EXPECT_GT(blue.b - blue.r, half.b - half.r + 10);
  model.settings.look.shading = ShadingModel::kajiya, model.settings.look.specular = 0;  // no white highlight
  EXPECT_LT(mean_colour(drawn(model)).r, 2) << "the coat's colour, or the undercoat's, shows through";
}

TEST_F(PaintedFrames, ColoursGoFromRootToTip) {
  FurredModel model = coarse(furred({Builtin::plane, 400}, {.length = 0.08, .inclination = 0}));
  model.settings.look.specular = 0;
  flood(model, Field::root_colour, glm::vec4(0.6f, 0, 0, 1));
  flood(model, Field::tip_colour, glm::vec4(0, 0, 0.6f, 1));
  const Image lying = draw(*renderer, model, small_frame(AutoView::top));
  const glm::dvec3 above = mean_colour(lying);
  EXPECT_GT(above.r, 2);
  EXPECT_GT(above.b, 2);
  flood(model, Field::tip_colour, glm::vec4(0, 0.6f, 0, 1));
  EXPECT_LT(mean_colour(draw(*renderer, model, small_frame(AutoView::top))).b, 1);
}

TEST_F(PaintedFrames, WaterDarkensAsTheCoatsOwn) {
  FurredModel model = ball();
  model.settings.look.specular = 0;
  const double dry = lightness(drawn(model));
  flood(model, Field::wetness, 0.5f);
  const double damp = lightness(drawn(model));
  flood(model, Field::wetness, 1.0f);
  const double wet = lightness(drawn(model));
  EXPECT_LT(damp, 0.93 * dry);
  EXPECT_LT(wet, 0.95 * damp);
  FurredModel whole = ball();
  whole.settings.look.specular = 0;
  whole.settings.coats[0].coat.wetness = 1;
  EXPECT_NEAR(wet, lightness(drawn(whole)), 0.25 * wet);
  flood(whole, Field::wetness, 1.0f);
  const double soaked = lightness(drawn(whole));
  EXPECT_NEAR(soaked, wet, 0.3 * wet) << "water on a wet coat is no more than wet";
}

TEST_F(PaintedFrames, WaterShines) {
  FurredModel model = ball();
  model.settings.look.shading = ShadingModel::kajiya;  // only the highlight differs
  model.settings.look.ambient = 0, model.settings.look.diffuse = 0, model.settings.look.specular_exponent = 8;
  const double dry = lightness(drawn(model));
  flood(model, Field::wetness, 1.0f);
  model.settings.look.specular_exponent = 8;
  const Image wet = drawn(model);
  const auto brightest = [](const Image& image) {
    int max = 0;
    for (std::size_t i = 0; i < image.rgba.size(); i += 4) max = std::max(max, int{image.rgba[i]});
    return max;
  };
  model.fields = ball().fields;
  EXPECT_GT(brightest(wet), brightest(drawn(model)));
  EXPECT_GT(dry, 0);
}

TEST_F(PaintedFrames, BareShowsSkin) {
  FurredModel model = ball();
  model.settings.look.skin = {0, 0.5f, 0};
  const Image furry = drawn(model);
  flood(model, Field::bare, 0.5f);
  const Image shorter = drawn(model);
  flood(model, Field::bare, 1.0f);
  const Image bare = drawn(model);
  EXPECT_LT(covered(shorter), covered(furry));
  EXPECT_LT(covered(bare), covered(shorter));
  EXPECT_NEAR(covered(bare), covered(drawn(ball(0))), 1e-3);
  EXPECT_GT(mean_colour(bare).g, mean_colour(bare).r + 20);
  EXPECT_LT(mean_colour(furry).g, mean_colour(furry).r);
}

TEST_F(PaintedFrames, ClumpAndCurlMoveStrands) {
  FurredModel model = coarse(furred({Builtin::plane, 400}, {.length = 0.04, .inclination = 0.2}));
  request = small_frame(AutoView::top, 256);
  const Image plain = drawn(model);
  flood(model, Field::clump, 1.0f);
  const Image clumped = drawn(model);
  EXPECT_GT(mean_difference(plain, clumped), 2);
  EXPECT_NEAR(lightness(clumped), lightness(plain), 0.35 * lightness(plain));
  flood(model, Field::clump, 0.0f);
  flood(model, Field::curl, 0.2f);
  const Image curled = drawn(model);
  EXPECT_GT(mean_difference(plain, curled), 2);
  EXPECT_NEAR(sum_of_alpha(curled), sum_of_alpha(plain), 0.05 * sum_of_alpha(plain));
  request.knobs = knobs_of(Tier::reference);
  request.knobs.trace.passes = 8;
  const double traced = lightness(drawn(model));
  EXPECT_GT(traced, 1.3 * lightness(plain)) << "curls are light";
  EXPECT_NEAR(lightness(curled), traced, 0.1 * traced);
}

TEST_F(PaintedFrames, AnAbruptEdgeKeepsBothSides) {
  FurredModel plain = ball(0.03), model = ball(0.03), whole = ball(0.03);
  const glm::vec4 blue(0, 0, 0.7f, 1);
  for (const Field field : {Field::root_colour, Field::tip_colour}) {
    paint(model, field, blue, on_the_right);
    flood(whole, field, blue);
  }
  paint(model, Field::density, glm::vec4(0.5f, 0, 0, 0), on_the_right);
  flood(whole, Field::density, 0.5f);
  const Image none = drawn(plain), some = drawn(model), every = drawn(whole);
  EXPECT_GT(glm::distance(colour_at(none, {0.7, 0.5}), colour_at(every, {0.7, 0.5})), 30);
  for (const double x : {0.3, 0.7}) {
    const Image& expected = x < 0.5 ? none : every;
    EXPECT_LT(glm::distance(colour_at(some, {x, 0.5}), colour_at(expected, {x, 0.5})), 1) << x;
  }
  // Between the two halves no pixel is lighter or darker than both: colours are mixed by their coverage.
  for (int x = 40; x < 88; ++x) {
    const glm::dvec3 at = colour_at(some, {x / 128.0, 0.5}, 2), a = colour_at(none, {x / 128.0, 0.5}, 2),
                     b = colour_at(every, {x / 128.0, 0.5}, 2);
    for (int k = 0; k < 3; ++k) {
      EXPECT_GT(at[k], std::min(a[k], b[k]) - 12) << x;
      EXPECT_LT(at[k], std::max(a[k], b[k]) + 12) << x;
    }
  }
}

TEST_F(PaintedFrames, ShadowsSeeThem) {
  FurredModel model = ball();
  model.settings.lights = {{.direction = {0, 0, -1}}};
  const auto light_share = [&] {  // at the middle of the picture
    drawn(model);
    const auto images = renderer->draw_aovs(make_frame(model.view(), request), std::array{Aov::shadow});
    EXPECT_TRUE(images.ok());
    const FloatImage& image = images->front();
    return image.rgba[4 * static_cast<std::size_t>(image.height / 2 * image.width + image.width / 2)];
  };
  EXPECT_LT(light_share(), 0.9f);
  flood(model, Field::density, 0.0f);
  EXPECT_GT(light_share(), 0.99f) << "fur that is not there shadows the skin";
}

TEST_F(PaintedFrames, OverlaysShowThem) {
  FurredModel model = ball();
  const auto middle = [&](Overlay overlay) {
    request.overlay = overlay;
    return colour_at(drawn(model), {0.5, 0.5});
  };
  const glm::dvec3 none = middle(Overlay::none);
  for (const Overlay overlay : {Overlay::density, Overlay::mask}) EXPECT_GT(middle(overlay).g, none.g + 60);  // yellow
  EXPECT_LT(middle(Overlay::wetness).g, none.g);
  flood(model, Field::mask, 0.0f);
  EXPECT_LT(middle(Overlay::mask).g, none.g);
  EXPECT_GT(middle(Overlay::density).g, none.g + 60);
  EXPECT_EQ(middle(Overlay::none), none) << "a mask is not drawn";
}

TEST_F(PaintedFrames, ADifferenceIsColouredWhereThereIsOne) {
  const FurredModel model = ball();
  drawn(model);
  FurFrame frame = make_frame(model.view(), request);
  const Image plain = *renderer->draw(frame);
  frame.overlay = Overlay::difference;
  const auto with = [&](float left, float right) {
    frame.difference.clear();
    for (const glm::vec3 position : model.model.surface.mesh().positions)
      frame.difference.push_back(position.x < 0 ? left : right);
    const Result<Image> image = renderer->draw(frame);
    EXPECT_TRUE(image.ok());
    return *image;
  };
  const Image image = with(0, 1);
  const glm::dvec3 same = colour_at(image, {0.3, 0.5}), changed = colour_at(image, {0.7, 0.5});
  EXPECT_GT(changed.g, changed.b + 60) << "yellow";
  EXPECT_LT(std::abs(same.g - same.b), 30) << "grey over the coat";
  const glm::dvec3 little = colour_at(with(0, 1e-6f), {0.7, 0.5});
  EXPECT_GT(little.b, little.g + 30) << "the least change is violet, and not grey";
  EXPECT_LT(largest_difference(with(0, 0), with(0, 0)), 1);

  frame.overlay = Overlay::none;  // it costs later frames nothing
  EXPECT_EQ(renderer->draw(frame)->rgba, plain.rgba);
}

TEST_F(PaintedFrames, ExtremesGiveFinitePictures) {
  FurredModel model = ball(0.08, 300);
  model.settings.lights = {{.kind = LightKind::point, .position = {0, 0, 0}, .intensity = 1e8}};
  model.settings.coats[0].coat.curl_turns = 20, model.settings.coats[0].coat.clump_size = 0.5,
  model.settings.coats[0].coat.tile = 0.01;
  model.settings.coats[0].coat.count = 10;  // on each of many tiles
  request = small_frame(AutoView::front, 24);
  request.background = Background::colour;
  model.settings.coats[0].coat.guard_hairs = 500;
  for (const bool max : {false, true}) {
    for (std::size_t i = first_painted; i < field_count; ++i) {
      const float value = max ? field_shapes[i].max : field_shapes[i].min;
      flood(model, field_at(i), glm::vec4(value));
    }
    if (max) flood(model, Field::bare, 0.4f);
    for (const ShadingModel shading : {ShadingModel::lengyel, ShadingModel::kajiya, ShadingModel::energy_conserving}) {
      model.settings.look.shading = shading;
      const Image image = drawn(model);
      for (std::size_t i = 3; i < image.rgba.size(); i += 4) ASSERT_EQ(image.rgba[i], 255);  // a NaN would leave 0
    }
  }
}

}  // namespace
}  // namespace pelage::testing::paint_test
