// Backplates of traced strands against rays that are cast here, and finished pictures against drawn ones.
#include <algorithm>
#include <array>
#include <cmath>
#include <optional>

#include "server/frames/fur_view.h"
#include "tests/frames/with_renderer.h"
#include "tests/support/furred_model.h"

namespace pelage::testing::traced_test {
namespace {

FurFrame frame_of(Renderer& renderer, const FurredModel& model, const FrameRequest& request) {
  sync_scene(renderer, model.view(), {{0, static_cast<std::uint32_t>(model.fields.size())}});
  return make_frame(model.view(), request);
}

glm::dvec3 pixel(const FloatImage& image, std::size_t i) {
  return {image.rgba[4 * i], image.rgba[4 * i + 1], image.rgba[4 * i + 2]};
}

struct Ray {
  glm::dvec3 from{0}, along{0};  // `along` has length 1 along the view direction
};

/// The ray through the centre of pixel `i` of a picture of that size; rows go from top to bottom.
Ray ray_through(const FurCamera& camera, std::size_t i, int width, int height) {
  const double x = (static_cast<double>(i % static_cast<std::size_t>(width)) + 0.5) / width;
  const double y = (static_cast<double>(i / static_cast<std::size_t>(width)) + 0.5) / height;
  const double up = double(camera.tan_half_fov), right = up * width / height;
  return {glm::dvec3(camera.position), glm::dvec3(camera.forward) + glm::dvec3(camera.right) * ((2 * x - 1) * right) +
                                           glm::dvec3(camera.up) * ((1 - 2 * y) * up)};
}

/// Depth along the view at which a ray enters a ball about the origin; none if it misses.
std::optional<double> depth_of_ball(const Ray& ray, double radius) {
  const double a = glm::dot(ray.along, ray.along), b = glm::dot(ray.from, ray.along);
  const double rest = b * b - a * (glm::dot(ray.from, ray.from) - radius * radius);
  if (rest < 0) return {};
  return (-b - std::sqrt(rest)) / a;
}

class Base : public WithRenderer {
 protected:
  Backplate base_of(const FurredModel& model, const FrameRequest& request) {
    Result<Backplate> base = renderer->draw_backplate(frame_of(*renderer, model, request));
    EXPECT_TRUE(base.ok()) << base.status().message;
    return std::move(base).value();
  }
};

FrameRequest askew(int width, int height) {
  FrameRequest request = small_frame();
  request.width = width, request.height = height;
  request.camera = {
      .automatic = AutoView::none, .position = {2.2, 1.8, 4.0}, .target = {0.1, -0.05, 0.06}, .up = {0.2, 1, 0}};
  return request;
}

FurredModel ball(int triangles = 4000) {
  return furred({Builtin::sphere, triangles}, {.length = 0.05, .inclination = 0.3});
}

const double ball_radius = 0.5 / std::sqrt(3.0);  // the bounding box's diagonal is 1

/// The ball is seen at all slopes up to 70 degrees, so a shift by a tenth of a pixel would show.
TEST_F(Base, RaysMeetTheBallWhereItIsDrawn) {
  const FurredModel model = ball(40'000);
  for (const glm::ivec2 size : {glm::ivec2(200, 120), glm::ivec2(120, 200), glm::ivec2(97, 61)}) {
    const FrameRequest request = askew(size.x, size.y);
    const FurFrame frame = frame_of(*renderer, model, request);
    const Backplate base = base_of(model, request);
    ASSERT_EQ(glm::ivec2(base.depth.width, base.depth.height), 2 * size);
    int seen = 0, beside = 0;
    for (std::size_t i = 0; i < base.depth.rgba.size() / 4; ++i) {
      const Ray ray = ray_through(frame.camera, i, base.depth.width, base.depth.height);
      if (!depth_of_ball(ray, 1.01 * ball_radius)) {
        ++beside;
        ASSERT_EQ(base.depth.rgba[4 * i], 0);
        ASSERT_EQ(base.beauty.rgba[4 * i + 3], 0);
      }
      const std::optional<double> depth = depth_of_ball(ray, ball_radius);
      if (!depth) continue;
      const glm::dvec3 normal = (ray.from + *depth * ray.along) / ball_radius;
      const double cosine = -glm::dot(normal, glm::normalize(ray.along));
      if (cosine < 0.35) continue;
      ++seen;
      ASSERT_NEAR(1 / double(base.depth.rgba[4 * i]), *depth, 1e-4 / cosine) << size.x << " " << i;
      ASSERT_GT(glm::dot(pixel(base.normal, i), normal), 0.9999) << size.x << " " << i;
      ASSERT_EQ(base.beauty.rgba[4 * i + 3], 1);
    }
    EXPECT_GT(seen, size.x * size.y / 4);
    EXPECT_GT(beside, size.x * size.y / 4);
  }
}

TEST_F(Base, RaysMeetThePlaneWhereItIsDrawn) {
  const FurredModel model = coarse(furred({Builtin::plane, 200}, {.length = 0.05}));
  const FrameRequest request = askew(200, 120);
  const FurFrame frame = frame_of(*renderer, model, request);
  const Backplate base = base_of(model, request);
  const double half = 0.5 / std::sqrt(2.0);
  int seen = 0;
  for (std::size_t i = 0; i < base.depth.rgba.size() / 4; ++i) {
    const Ray ray = ray_through(frame.camera, i, base.depth.width, base.depth.height);
    const double depth = -ray.from.y / ray.along.y;
    const glm::dvec3 position = ray.from + depth * ray.along;
    const double off = std::max(std::abs(position.x), std::abs(position.z)) - half;
    if (std::abs(off) < 0.004) continue;  // a pixel at the edge
    ASSERT_EQ(base.depth.rgba[4 * i] > 0, off < 0) << i;
    if (off > 0) continue;
    ++seen;
    ASSERT_NEAR(1 / double(base.depth.rgba[4 * i]), depth, 2e-6) << i;
    ASSERT_GT(pixel(base.normal, i).y, 0.99999);
  }
  EXPECT_GT(seen, 2000);
}

/// Skin under fur is a matt surface of the undercoat's colour, without shadows; a rectangular light emits by the
/// cosine.
TEST_F(Base, SkinIsLitAsIfNothingGrewOnIt) {
  FurredModel model = ball();
  Look& look = model.settings.look;
  look.ambient = 0.3, look.diffuse = 0.8;
  const glm::dvec3 area_position(0.2, 1.1, 1.4), aim = glm::normalize(glm::dvec3(0, -1, -1));
  model.settings.lights = {{.direction = {-1, -1, -0.5}, .colour = {1, 0.5f, 0.25f}, .intensity = 0.7},
                           {.kind = LightKind::area,
                            .direction = aim,
                            .position = area_position,
                            .colour = {0.2f, 0.6f, 1},
                            .intensity = 2}};
  const FrameRequest request = askew(120, 90);
  const FurFrame frame = frame_of(*renderer, model, request);
  const glm::dvec3 light_position(frame.lights[1].position);
  const Backplate base = base_of(model, request);
  int lit = 0;
  for (std::size_t i = 0; i < base.depth.rgba.size() / 4; ++i) {
    if (base.beauty.rgba[4 * i + 3] == 0) continue;
    const Ray ray = ray_through(frame.camera, i, base.depth.width, base.depth.height);
    const glm::dvec3 position = ray.from + ray.along / double(base.depth.rgba[4 * i]), normal = pixel(base.normal, i);
    const glm::dvec3 apart = light_position - position, to_light = glm::normalize(apart);
    glm::dvec3 light =
        0.7 * glm::dvec3(1, 0.5, 0.25) * std::max(glm::dot(normal, glm::normalize(glm::dvec3(1, 1, 0.5))), 0.0);
    light += 2.0 * glm::dvec3(glm::vec3(0.2f, 0.6f, 1)) * std::max(-glm::dot(to_light, aim), 0.0) *
             std::max(glm::dot(normal, to_light), 0.0) / glm::dot(apart, apart);
    const glm::dvec3 albedo = pixel(base.albedo, i), direct = pixel(base.direct, i);
    ASSERT_LT(glm::length(direct - 0.8 * albedo * light), 1e-4) << i;
    ASSERT_LT(glm::length(pixel(base.beauty, i) - direct - 0.3 * albedo), 1e-5) << i;
    lit += glm::length(direct) > 0.1;
  }
  EXPECT_GT(lit, 1000);
}

TEST_F(Base, OfTheKnobsOnlyEyeStepsCount) {
  FurredModel model = ball();
  model.settings.coats[0].coat.pattern.kind = PatternKind::spots;
  model.settings.lights[0].cast_shadow = CastShadow::hard;
  model.settings.eyes = {{.position = {0, 0, 1}, .radius = 0.08}};
  FrameRequest request = askew(80, 60);
  const Backplate before = base_of(model, request);
  request.knobs = knobs_of(Tier::detailed);
  request.knobs.eye_steps = knobs_of(Tier::interactive).eye_steps, request.knobs.scale = 0.5;
  model.settings.ground = {.visible = true, .height = {}, .shadow = 1, .contact = 1};
  model.settings.curves = {{.curves = {{{0, 0, 1}, {0.2, 0.2, 1.5}}}, .width_root = 0.02}};
  const Backplate after = base_of(model, request);
  EXPECT_EQ(before.beauty.rgba, after.beauty.rgba);
  EXPECT_EQ(before.direct.rgba, after.direct.rgba);
  EXPECT_EQ(before.depth.rgba, after.depth.rgba);
  request.knobs.eye_steps = 0;
  EXPECT_NE(base_of(model, request).beauty.rgba, after.beauty.rgba);
}

/// Drawing a backplate changes no later frame.
TEST_F(Base, LeavesFramesAsTheyAre) {
  FurredModel model = coarse(furred({Builtin::creature, 2000}));
  model.settings.coats[0].coat.pattern.kind = PatternKind::spots;
  model.settings.skin = {{.centre = {0, 0, 0.3}, .radii = glm::dvec3(0.1)}};
  const Image before = draw(*renderer, model, small_frame());
  base_of(model, askew(64, 64));
  EXPECT_EQ(draw(*renderer, model, small_frame()).rgba, before.rgba);
}

/// Without ambient light and without surroundings to reflect, all light is direct, on skin, bare skin and eyes.
TEST_F(Base, DirectIsWhatLightsBring) {
  FurredModel model = ball();
  model.settings.skin = {{.centre = {0.8, 0.2, 0.6}, .radii = glm::dvec3(0.25), .wetness = 0.5}};
  model.settings.eyes = {{.position = {0, 0, 1}, .radius = 0.1, .lids = Lids{}}};
  FrameRequest request = askew(120, 90);
  const auto beside = [](const Backplate& base) {  // range of the light that is not direct
    glm::dvec2 ends(1e9, -1e9);
    for (std::size_t i = 0; i < base.beauty.rgba.size(); ++i) {
      if (i % 4 == 3) continue;
      const double rest = double(base.beauty.rgba[i]) - double(base.direct.rgba[i]);
      EXPECT_TRUE(std::isfinite(rest));
      ends = {std::min(ends.x, rest), std::max(ends.y, rest)};
    }
    return ends;
  };
  const glm::dvec2 usual = beside(base_of(model, request));
  EXPECT_GT(usual.x, -1e-4);
  EXPECT_GT(usual.y, 0.1);
  model.settings.look.ambient = 0, request.background = Background::colour, request.background_colour = glm::vec3(0);
  const glm::dvec2 lights = beside(base_of(model, request));
  EXPECT_GT(lights.x, -1e-4);
  EXPECT_LT(lights.y, 1e-4);
  model.settings.lights.clear();
  const FloatImage dark = base_of(model, request).direct;
  for (std::size_t i = 0; i < dark.rgba.size() / 4; ++i) ASSERT_EQ(pixel(dark, i), glm::dvec3(0));
}

TEST_F(Base, IsFiniteUnderBlindingLights) {
  FurredModel model = ball();
  model.settings.skin = {{.centre = {0.8, 0.2, 0.6}, .radii = glm::dvec3(0.25), .roughness = 0.02, .wetness = 1}};
  model.settings.eyes = {{.position = {0, 0, 1}, .radius = 0.1}};
  const glm::dvec3 on_skin = glm::normalize(glm::dvec3(0.8, 0.2, 0.6));
  model.settings.lights.clear();
  for (const LightKind kind : {LightKind::directional, LightKind::point, LightKind::spot, LightKind::area})
    model.settings.lights.push_back({.kind = kind, .direction = -on_skin, .position = on_skin, .intensity = 1e8});
  const Backplate base = base_of(model, askew(60, 40));
  for (const FloatImage* image : {&base.beauty, &base.direct, &base.albedo, &base.normal, &base.depth})
    EXPECT_TRUE(std::all_of(image->rgba.begin(), image->rgba.end(), [](float v) { return std::isfinite(v); }));
  EXPECT_GT(*std::max_element(base.beauty.rgba.begin(), base.beauty.rgba.end()), 1e7f);
}

TEST_F(Base, ALargeFrameIsNotDoubled) {
  const FurredModel model = coarse(furred({Builtin::sphere, 500}));
  EXPECT_EQ(base_of(model, askew(1024, 8)).beauty.width, 2048);
  EXPECT_EQ(base_of(model, askew(8, 1025)).beauty.height, 1025);
}

class Finish : public WithRenderer {
 protected:
  void SetUp() override {
    WithRenderer::SetUp();
    model.settings.ground = {.visible = true, .height = {}, .shadow = 0.8, .contact = 0.8};
  }
  FloatImage light_of(const FurFrame& frame) {
    return std::move(renderer->draw_aovs(frame, std::array{Aov::beauty}).value()[0]);
  }
  /// Largest difference between the drawn picture and the one finished from the same light, in steps of 8 and of 16
  /// bits.
  std::pair<int, int> steps_apart(const FrameRequest& request) {
    FurFrame frame = frame_of(*renderer, model, request);
    if (frame.overlay == Overlay::difference) frame.difference.assign(model.fields.size(), 0.6f);
    const FloatImage light = light_of(frame);
    const Image drawn = renderer->draw(frame).value();
    const Image16 deep = renderer->draw_deep(frame).value();
    FurFrame other = frame;  // the view drawn last must not matter to finish()
    other.camera.tan_half_fov *= 2;
    EXPECT_TRUE(renderer->draw_backplate(other).ok());
    const Image finished = renderer->finish(frame, light).value();
    const Image16 finished_deep = renderer->finish_deep(frame, light).value();
    int largest = 0;
    for (std::size_t i = 0; i < deep.rgba.size(); ++i)
      largest = std::max(largest, std::abs(int(deep.rgba[i]) - int(finished_deep.rgba[i])));
    return {largest_difference(drawn, finished), largest};
  }

  FurredModel model = coarse(furred({Builtin::creature, 2000}));
};

TEST_F(Finish, IsWhatIsDrawnOfTheSameLight) {
  for (const Background background : {Background::transparent, Background::studio, Background::colour}) {
    for (const ToneMap tone_map : {ToneMap::none, ToneMap::filmic}) {
      FrameRequest request = askew(100, 70);
      request.background = background, request.background_colour = {0.1f, 0.4f, 0.7f};
      request.tone_map = tone_map, request.exposure = 0.7;
      const auto [steps, deep] = steps_apart(request);
      EXPECT_LE(steps, 1) << int(background);
      EXPECT_LE(deep, 2) << int(background);
    }
  }
}

TEST_F(Finish, LaysFieldsOverThePictureAsOverARasterizedOne) {
  for (const Overlay overlay : {Overlay::direction, Overlay::strokes, Overlay::length, Overlay::density,
                                Overlay::wetness, Overlay::mask, Overlay::difference, Overlay::bald, Overlay::wire}) {
    FrameRequest request = askew(100, 70);
    request.overlay = overlay;
    const auto [steps, deep] = steps_apart(request);
    EXPECT_LE(steps, 1) << int(overlay);
    EXPECT_LE(deep, 2) << int(overlay);
  }
}

TEST_F(Finish, ShowsTheLightThatItIsGiven) {
  FurFrame frame = frame_of(*renderer, model, askew(3, 2));
  frame.exposure = 1;
  const FloatImage light{
      3, 2, {0.1f, 0, 0, 1, 0, 0.1f, 0, 1, 0, 0, 0.1f, 1, 0.25f, 0.25f, 0.25f, 0.5f, 0, 0, 0, 0.5f, 0, 0, 0, 0}};
  const std::vector<std::uint8_t> expected = {124, 0,   0,   255, 0, 124, 0, 255, 0, 0, 124, 255,
                                              255, 255, 255, 128, 0, 0,   0, 128, 0, 0, 0,   0};
  const Image image = renderer->finish(frame, light).value();
  for (std::size_t i = 0; i < expected.size(); ++i) EXPECT_NEAR(image.rgba[i], expected[i], 1) << i;
}

}  // namespace
}  // namespace pelage::testing::traced_test
