// Shadows from maps: they darken what lies behind, agree with the estimate where both are right, and are cached.
#include <array>
#include <cmath>
#include <glm/gtc/type_ptr.hpp>

#include "renderer/frame/renderer.h"
#include "server/frames/fur_view.h"
#include "tests/gl/with_renderer.h"
#include "tests/support/furred_model.h"

namespace pelage::testing::shadow_test {
namespace {

class Shadows : public WithRenderer {
 protected:
  /// Draws the model in one light. With light and camera above, parts that shadow each other are not seen.
  Image picture(FurredModel& model, const Light& light, bool maps, AutoView from = AutoView::top) {
    model.settings.lights = {light};
    FrameRequest request = shells_frame(from, 160);
    request.knobs.shells.shadow_maps = maps;
    return draw(*renderer, model, request);
  }
  /// Premultiplied linear light without ambient light.
  FloatImage light_of(FurredModel& model, const FrameRequest& request) {
    model.settings.look.ambient = 0;
    sync_shells(*renderer, model, {{0, static_cast<std::uint32_t>(model.fields.size())}});
    return renderer->draw_aovs(make_frame(model.view(), request), std::array{Aov::beauty}).value()[0];
  }
  /// Share of that light that is unshadowed in each pixel; 0 where there is none.
  std::vector<double> unshadowed_share(FurredModel& model, FrameRequest request) {
    const FloatImage shadowed = light_of(model, request);
    request.knobs.shells.shadow_maps = request.knobs.shells.self_shadow = false;
    const FloatImage unshadowed = light_of(model, request);
    std::vector<double> shares;
    for (std::size_t i = 1; i < unshadowed.rgba.size(); i += 4)
      shares.push_back(unshadowed.rgba[i] > 1e-4f ? double{shadowed.rgba[i]} / double{unshadowed.rgba[i]} : 0);
    return shares;
  }
  /// Positions of the request's pixels, and the normals of the skin there.
  std::vector<FloatImage> positions_of(const FurredModel& model, FrameRequest request) {
    request.knobs = {};
    return renderer->draw_aovs(make_frame(model.view(), request), std::array{Aov::position, Aov::normal}).value();
  }
  static double mean(const Image& image) {
    const glm::dvec3 colour = mean_colour(image);
    return (colour.r + colour.g + colour.b) / 3;
  }
};

const Light from_above{.direction = {0, -1, 0}, .intensity = 1};

TEST_P(Shadows, ShellMapsAgreeWithTheEstimateOnAPlane) {
  // Fur seen along the light: the map holds the transmittance of the strands above, the estimate their mean.
  FurredModel model = furred({Builtin::plane, 200}, {.length = 0.05, .inclination = 0.6});
  Light light = from_above;
  const double estimate = mean(picture(model, light, false));
  light.self_shadow_maps = true;
  const double maps = mean(picture(model, light, true));
  EXPECT_NEAR(maps, estimate, 0.15 * estimate);
  model.settings.look.self_shadow = 0;
  EXPECT_GT(mean(picture(model, light, false)), estimate * 1.05);  // there is a shadow to agree on
}

/// Share of light that shadows leave on nearly black fur, which does not scatter what it stops: from the maps and from
/// the estimate. The light comes from a side, because what is seen along the light has nothing above it. The maps leave
/// more: light falls through gaps on what is seen through them, and the mean transmittance of strands is more than the
/// transmittance of the mean depth.
TEST_P(Shadows, ShellMapsHoldTheOpticalDepthOfTheFur) {
  FurredModel model = furred({Builtin::plane, 200}, {.length = 0.05, .inclination = 0.3});
  model.settings.coats[0].coat.ramp = {{0, glm::vec3(0.02f)}};
  model.settings.coats[0].coat.count = 4000;
  FrameRequest request = shells_frame(AutoView::top, 160);
  const auto mean_share = [&](bool maps) {
    model.settings.lights = {{.direction = {1, -1, 0.3}}};
    model.settings.lights[0].self_shadow_maps = maps;
    request.knobs.shells.shadow_maps = maps;
    double sum = 0, count = 0;
    for (const double share : unshadowed_share(model, request))
      if (share > 0) sum += share, ++count;
    return sum / count;
  };
  const double estimate = mean_share(false), maps = mean_share(true);
  RecordProperty("shares", std::to_string(estimate) + " " + std::to_string(maps));
  EXPECT_GT(estimate, 0.2);
  EXPECT_LT(estimate, 0.9);
  EXPECT_GT(std::log(maps) / std::log(estimate), 0.5);
  EXPECT_LT(std::log(maps) / std::log(estimate), 1);
}

TEST_P(Shadows, CastShadowOnlyDarkens) {
  FurredModel model = furred({Builtin::knot, 2000}, {.length = 0.01});
  model.settings.look.ambient = 0.2;  // so little that the means are mostly direct light
  Light light = from_above;
  const Image unshadowed = picture(model, light, true, AutoView::front);
  light.cast_shadow = CastShadow::hard;
  const Image hard = picture(model, light, true, AutoView::front);
  light.cast_shadow = CastShadow::soft;
  const Image soft = picture(model, light, true, AutoView::front);
  for (std::size_t i = 0; i < unshadowed.rgba.size(); ++i) {
    ASSERT_LE(hard.rgba[i], unshadowed.rgba[i] + 1);
    ASSERT_LE(hard.rgba[i], soft.rgba[i] + 1);
    ASSERT_LE(soft.rgba[i], unshadowed.rgba[i] + 1);
  }
  EXPECT_LT(mean(hard), 0.95 * mean(unshadowed));
  EXPECT_LT(mean(soft), 0.98 * mean(unshadowed));
  EXPECT_GT(mean(soft), 1.002 * mean(hard));
  light.cast_shadow = CastShadow::penumbra;
  EXPECT_LT(mean(picture(model, light, true, AutoView::front)), mean(hard)) << "fur casts it, too";
  FurredModel sleek = furred({Builtin::knot, 2000}, {.length = 0.003});
  sleek.settings.look.ambient = 0.2;
  const double penumbra = mean(picture(sleek, light, true, AutoView::front));
  light.cast_shadow = CastShadow::hard;
  EXPECT_NEAR(penumbra, mean(picture(sleek, light, true, AutoView::front)), 0.02 * mean(unshadowed));
}

/// On bare skin a hard shadow falls where a ray to the light hits the body, from whatever side the light comes.
TEST_P(Shadows, HardShadowsFallWhereRaysSay) {
  FurredModel model = furred({Builtin::knot, 4000}, {.length = 0});
  FrameRequest request = shells_frame(AutoView::front, 128);
  request.knobs.shells.shadow_maps = true;
  for (const glm::dvec3 along : {glm::dvec3(0.3, -1, -0.6), glm::dvec3(-1, 0.4, -0.5)}) {
    model.settings.lights = {{.direction = along, .cast_shadow = CastShadow::hard}};
    const std::vector<double> shares = unshadowed_share(model, request);
    const std::vector<FloatImage> positions = positions_of(model, request);
    const glm::dvec3 to_light = -glm::normalize(along);
    int occluded = 0, lit = 0, wrong = 0;
    for (std::size_t i = 0; i < positions[0].rgba.size(); i += 4) {
      const auto value = [&](std::size_t aov) { return glm::dvec3(glm::make_vec3(&positions[aov].rgba[i])); };
      if (positions[0].rgba[i + 3] < 1 || glm::dot(value(1), to_light) < 0.3) continue;
      const bool hidden = model.model.surface.raycast(value(0) + 0.015 * to_light, to_light).has_value();
      (hidden ? occluded : lit) += 1;
      wrong += hidden != (shares[i / 4] < 0.5);
    }
    EXPECT_GT(occluded, 100);
    EXPECT_GT(lit, 500);
    EXPECT_LT(wrong, 0.05 * (occluded + lit));
  }
}

/// Directions to a light, evenly distributed over the disc that it subtends.
std::vector<glm::dvec3> rays_to(const FurLight& light, int count) {
  const glm::dvec3 axis = -glm::dvec3(light.direction);
  const glm::dvec3 right = glm::normalize(glm::cross(axis, glm::dvec3(0.1, 0.2, 0.97))), up = glm::cross(axis, right);
  std::vector<glm::dvec3> rays;
  for (int i = 0; i < count; ++i) {
    const double radius = std::tan(double{light.angle}) * std::sqrt((i + 0.5) / count), angle = 2.399963 * i;
    rays.push_back(glm::normalize(axis + radius * (std::cos(angle) * right + std::sin(angle) * up)));
  }
  return rays;
}

/// On bare skin a penumbra is the share of the light's disc that rays do not reach.
TEST_P(Shadows, PenumbrasAreTheShareOfTheLightThatRaysMiss) {
  FurredModel model = furred({Builtin::knot, 4000}, {.length = 0});
  FrameRequest request = shells_frame(AutoView::front, 96);
  request.knobs.shells.shadow_maps = true, request.knobs.shells.shadow_resolution = 1024;
  for (const double degrees : {3.0, 12.0}) {
    model.settings.lights = {
        {.direction = {0.3, -1, -0.6}, .angle_degrees = degrees, .cast_shadow = CastShadow::penumbra}};
    const std::vector<double> shares = unshadowed_share(model, request);
    const std::vector<FloatImage> positions = positions_of(model, request);
    const FurFrame frame = make_frame(model.view(), request);
    const std::vector<glm::dvec3> rays = rays_to(frame.lights[0], 64);
    double error = 0, bias = 0, count = 0, between = 0;
    for (std::size_t i = 0; i < positions[0].rgba.size(); i += 4) {
      const auto value = [&](std::size_t aov) { return glm::dvec3(glm::make_vec3(&positions[aov].rgba[i])); };
      if (positions[0].rgba[i + 3] < 1 || glm::dot(value(1), -glm::dvec3(frame.lights[0].direction)) < 0.3) continue;
      double unoccluded = 0;
      for (const glm::dvec3& ray : rays)
        unoccluded += model.model.surface.raycast(value(0) + 0.01 * value(1), ray) ? 0 : 1.0 / 64;
      error += std::abs(shares[i / 4] - unoccluded), bias += shares[i / 4] - unoccluded, ++count;
      between += unoccluded > 0.1 && unoccluded < 0.9;
    }
    EXPECT_GT(between, 0.01 * degrees * count) << degrees;  // there is a penumbra to compare
    EXPECT_LT(error, 0.05 * count) << degrees;
    EXPECT_LT(std::abs(bias), 0.02 * count) << degrees;
  }
}

// Compares the light below y = -.1 under shorter and longer fur above the middle.
TEST_P(Shadows, PenumbrasAreThoseOfFurNotOfSkin) {
  FurredModel model = furred({Builtin::knot, 4000}, {.length = 0.015});
  model.settings.coats[0].coat.count = 3000;
  const auto light_below = [&](CastShadow shadow, float length_above) {
    for (std::uint32_t v = 0; v < model.fields.size(); ++v) {
      if (model.model.surface.mesh().positions[v].y > 0) model.fields.set(Field::length, v, {length_above, 0, 0, 0});
    }
    Light light{.direction = {0.3, -1, -0.2}, .intensity = 1};
    light.cast_shadow = shadow;
    model.settings.lights = {light};
    FrameRequest request = shells_frame(AutoView::front, 160);
    request.knobs.shells.shadow_maps = true;
    const FloatImage lit = light_of(model, request), positions = positions_of(model, request)[0];
    double sum = 0;
    for (std::size_t i = 0; i < lit.rgba.size(); i += 4) {
      const bool below = positions.rgba[i + 3] > 0.9f && positions.rgba[i + 1] < -0.1f;
      sum += below ? double(lit.rgba[i + 1]) : 0;
    }
    return sum;
  };
  const double under_short = light_below(CastShadow::penumbra, 0.015f),
               under_long = light_below(CastShadow::penumbra, 0.08f);
  EXPECT_GT(under_short, 10);
  EXPECT_LT(under_long, 0.9 * under_short);
  EXPECT_NEAR(light_below(CastShadow::hard, 0.08f), light_below(CastShadow::hard, 0.015f), 0.05 * under_short);
}

TEST_P(Shadows, KnobAndLightMustBothAsk) {
  FurredModel model = furred({Builtin::knot, 1000});
  Light light = from_above;
  const Image plain = picture(model, light, true);
  light.cast_shadow = CastShadow::hard, light.self_shadow_maps = true;
  EXPECT_EQ(picture(model, light, false).rgba, plain.rgba);
  EXPECT_NE(picture(model, light, true).rgba, plain.rgba);
}

TEST_P(Shadows, MapsAreCachedUntilFieldsOrLightChange) {
  FurredModel model = furred({Builtin::sphere, 300});
  Light light = from_above;
  light.self_shadow_maps = true;
  picture(model, light, true);
  FrameRequest request = shells_frame(AutoView::left, 160);
  request.knobs.shells.shadow_maps = true;
  const auto made = [&] {
    return counters_of(*renderer, make_frame(model.view(), request)).objects > 0;  // new textures: maps were drawn
  };
  EXPECT_FALSE(made());  // another view uses the same maps
  model.settings.lights[0].direction = {1, -1, 0};
  EXPECT_TRUE(made());
  EXPECT_FALSE(made());
  model.fields.set(5, {{0.5f, 0}, 0.05f, 0});
  sync_shells(*renderer, model, {{5, 6}});
  EXPECT_TRUE(made());
}

TEST_P(Shadows, LightsInsideTheModelAndTinyMapsAreFine) {
  FurredModel model = furred({Builtin::sphere, 300});
  for (const glm::dvec3 position : {glm::dvec3(0), glm::dvec3(0.4, 0, 0), glm::dvec3(0, 1e6, 0)}) {
    for (const LightKind kind : {LightKind::point, LightKind::spot}) {
      model.settings.lights = {{.kind = kind,
                                .position = position,
                                .intensity = 1e8,
                                .self_shadow_maps = true,
                                .cast_shadow = CastShadow::soft}};
      FrameRequest request = shells_frame(AutoView::front, 24);
      request.knobs.shells.shadow_maps = true;
      request.knobs.shells.shadow_resolution = 1;
      request.background = Background::colour;
      const Image image = draw(*renderer, model, request);
      for (std::size_t i = 3; i < image.rgba.size(); i += 4) ASSERT_EQ(image.rgba[i], 255);
    }
  }
}

TEST_P(Shadows, ASpotLightsOnlyItsCone) {
  FurredModel model = furred({Builtin::plane, 200}, {.length = 0.02, .inclination = 0.8});
  model.settings.look.ambient = 0;
  Light light{.kind = LightKind::spot, .direction = {0, -1, 0}, .position = {0, 1, 0}, .intensity = 1};
  const double full = mean(picture(model, {.kind = LightKind::point, .position = {0, 1, 0}}, false));
  light.cone_degrees = 80;
  EXPECT_NEAR(mean(picture(model, light, false)), full, 0.02 * full);
  light.cone_degrees = 10;
  EXPECT_LT(mean(picture(model, light, false)), 0.5 * full);
}

/// Share of the light that is left where a light at the camera's position sees skin between strands. Skin under fur has
/// the colour of the roots, and only that is red.
double light_between_strands(Renderer& renderer, Coat coat) {
  FurredModel model = furred({Builtin::plane, 200}, {.length = 0.05, .inclination = 0.5});
  coat.ramp = {{0, {1, 0, 0}}, {0.01, {0, 1, 0}}, {1, {0, 1, 0}}};
  model.settings.coats[0].coat = coat;
  FrameRequest request = shells_frame(AutoView::top, 256);
  request.knobs.shells = {.count = 16, .shadow_maps = true, .shadow_resolution = 1024};
  FurFrame frame = make_frame(model.view(), request);
  const VertexRange all{0, static_cast<std::uint32_t>(model.fields.size())};
  sync_shells(renderer, model, {all});
  frame.lights = {{.kind = LightKind::point, .position = frame.camera.position, .self_shadow_maps = true}};
  frame.look.ambient = 0;
  const auto light_with = [&](const FurFrame& lit) {
    return renderer.draw_aovs(lit, std::array{Aov::beauty}).value()[0];
  };
  FurFrame without_shadow = frame, colours = frame;
  without_shadow.knobs.shells.shadow_maps = without_shadow.knobs.shells.self_shadow = false;
  colours.lights.clear(), colours.look.ambient = colours.look.ambient_floor = 1;
  const FloatImage shadowed = light_with(frame), unshadowed = light_with(without_shadow), seen = light_with(colours);
  double sum = 0, count = 0;
  for (std::size_t i = 0; i < shadowed.rgba.size(); i += 4) {
    if (seen.rgba[i] < 0.9f) continue;
    sum += double{shadowed.rgba[i]} / double{unshadowed.rgba[i]}, ++count;
  }
  EXPECT_GT(count, 100);
  return sum / count;
}

TEST_P(Shadows, WhereALightSeesNoFurNothingIsDark) {
  const Coat sparse{.count = 400, .width_root = 0.002, .width_tip = 0.001, .clump = 0};
  const double plain = light_between_strands(*renderer, sparse);
  EXPECT_GT(plain, 0.9);
  Coat varied = sparse;
  varied.variation.length = 1, varied.variation.lean = 1;
  EXPECT_GT(light_between_strands(*renderer, varied), plain - 0.03);
  Coat tufted = sparse;
  tufted.tufts = {.gather = 1, .size = 0.12, .scales = 1};
  EXPECT_GT(light_between_strands(*renderer, tufted), plain - 0.03);
}

/// Three horizontal rectangles, one above the other: the highest over x < 0, the middle one over all x, the lowest up
/// to x = .6 or, with `gap`, only at the edge near x = -1.
RawModel three_levels(bool gap) {
  RawModel raw;
  const auto level = [&](double y, double from, double to) {
    const auto first = static_cast<std::uint32_t>(raw.positions.size());
    for (const auto& [x, z] : {std::pair{from, -1.0}, {from, 1.0}, {to, 1.0}, {to, -1.0}})
      raw.positions.emplace_back(x, y, z);
    raw.face_sizes.push_back(4);
    for (std::uint32_t i = 0; i < 4; ++i) raw.corners.push_back(first + i);
  };
  level(1, -1, 0), level(0.5, -1, 1), level(0, -1, gap ? -0.99 : 0.6);  // the camera sees nothing of the lowest
  return raw;
}

TEST_P(Shadows, WhatLiesBelowASurfaceDoesNotChangeTheSoftShadowOnIt) {
  // The map of occluded skin is white beside the edge of the shadow too, where the lowest level is hidden.
  const auto draw_levels = [&](bool gap) {
    FurredModel model = furred(three_levels(gap), {.length = 0});
    FrameRequest request = shells_frame(AutoView::front, 200);
    request.camera = {.automatic = AutoView::none, .position = {2, 2.2, 0}, .target = {0, 0.5, 0}, .fov_degrees = 45};
    request.knobs.shells.shadow_maps = true;
    model.settings.lights = {{.direction = {0, -1, 0}, .cast_shadow = CastShadow::soft}};
    return draw(*renderer, model, request);
  };
  const Image with_gap = draw_levels(true), without_gap = draw_levels(false);
  EXPECT_LT(mean_difference(with_gap, without_gap), 0.1);
}

INSTANTIATE_TEST_SUITE_P(Gl, Shadows, both_backends(), name_of);

}  // namespace
}  // namespace pelage::testing::shadow_test
