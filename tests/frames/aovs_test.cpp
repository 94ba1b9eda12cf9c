// AOVs of an EXR, 16-bit pictures, the studio background and overlays.
#include <algorithm>
#include <cmath>
#include <map>
#include <set>

#include "base/colour_space.h"
#include "server/frames/fur_view.h"
#include "tests/frames/with_renderer.h"
#include "tests/support/furred_model.h"

namespace pelage::testing::aovs_test {
namespace {

class AovFrames : public WithRenderer {
 protected:
  std::vector<FloatImage> aovs_of(const FurredModel& model, const FrameRequest& request, std::vector<Aov> aovs) {
    const VertexRange all{0, static_cast<std::uint32_t>(model.fields.size())};
    sync_scene(*renderer, model.view(), {all});
    Result<std::vector<FloatImage>> images = renderer->draw_aovs(make_frame(model.view(), request), aovs);
    EXPECT_TRUE(images.ok()) << images.status().message;
    return std::move(images).value();
  }
};

glm::vec3 pixel(const FloatImage& image, std::size_t i) {
  return {image.rgba[4 * i], image.rgba[4 * i + 1], image.rgba[4 * i + 2]};
}

TEST_F(AovFrames, DepthIsWhereOpacityCrossesHalf) {
  const FurredModel model = coarse(furred({Builtin::sphere, 1000}, {.length = 0.08, .inclination = 0.3}));
  FrameRequest request = small_frame(AutoView::front, 192);
  for (const double strands : {0.4, 1.5, 1000.0}) {
    request.knobs.raster.strands = strands;
    const auto images = aovs_of(model, request, {Aov::beauty, Aov::depth});
    int near_edge = 0, wrong = 0, partial = 0;
    for (std::size_t i = 0; i < images[0].rgba.size() / 4; ++i) {
      const float alpha = images[0].rgba[4 * i + 3];
      const bool there = images[1].rgba[4 * i] > 0;
      partial += alpha > 0.05f && alpha < 0.95f;
      if (std::abs(alpha - 0.5f) < 0.02f)
        ++near_edge;
      else if (there != (alpha > 0.5f))
        ++wrong;
    }
    EXPECT_GT(partial, 100) << strands;
    EXPECT_EQ(wrong, 0) << strands << " strands a pixel, " << near_edge << " near half";
  }
}

// Between a lit knot and a shadowed one, light may change by more or less than half floats can hold.
TEST_F(AovFrames, LightsOfAnyBrightnessHaveShadows) {
  FurredModel model = coarse(furred({Builtin::sphere, 1000}, {.length = 0.08, .inclination = 0.3}));
  for (const double intensity : {1e-8, 1.0, 1e8}) {
    for (Light& light : model.settings.lights) light.intensity = intensity;
    const auto images = aovs_of(model, small_frame(), {Aov::beauty, Aov::direct, Aov::shadow});
    for (const FloatImage& image : images)
      for (const float value : image.rgba) ASSERT_TRUE(std::isfinite(value) && value >= 0) << intensity;
  }
}

TEST_F(AovFrames, DenseShortFurLiesOnTheSphere) {
  FurredModel model = coarse(furred({Builtin::sphere, 4000}, {.length = 0.004, .inclination = 0}));
  model.settings.coats[0].coat.bend = 0;
  const FrameRequest request = small_frame();
  const FurFrame frame = make_frame(model.view(), request);
  const auto images = aovs_of(model, request, {Aov::depth, Aov::position, Aov::normal, Aov::tangent});
  const double radius = 0.5 / std::sqrt(3.0);  // the bounding box's diagonal is 1
  int seen = 0;
  double upright = 0;
  for (std::size_t i = 0; i < images[0].rgba.size() / 4; ++i) {
    if (images[1].rgba[4 * i + 3] < 1) continue;
    const glm::vec3 position = pixel(images[1], i), normal = pixel(images[2], i), tangent = pixel(images[3], i);
    if (glm::dot(glm::normalize(position), -frame.camera.forward) < 0.5f)
      continue;  // the rim mixes in what lies behind
    ++seen;
    EXPECT_NEAR(glm::length(position), radius, 0.006);
    EXPECT_NEAR(1 / images[0].rgba[4 * i], glm::dot(position - frame.camera.position, frame.camera.forward), 0.006);
    EXPECT_GT(glm::dot(normal, glm::normalize(position)), 0.99f);
    upright += double{glm::dot(tangent, normal)};
    EXPECT_NEAR(glm::length(normal), 1, 1e-5);
  }
  EXPECT_GT(seen, 2000);
  EXPECT_GT(upright / seen, 0.9);
}

TEST_F(AovFrames, WithoutAmbientAllLightIsDirect) {
  FurredModel model = coarse(furred({Builtin::torus, 1000}));
  FrameRequest request = small_frame();
  for (const ShadingModel shading : {ShadingModel::kajiya, ShadingModel::lengyel, ShadingModel::marschner}) {
    model.settings.look.shading = shading;
    model.settings.look.ambient = 0;
    const auto dark = aovs_of(model, request, {Aov::beauty, Aov::direct});
    model.settings.look.ambient = 1;
    const auto lit = aovs_of(model, request, {Aov::beauty, Aov::direct});
    float ambient = 0;
    for (std::size_t i = 0; i < dark[0].rgba.size() / 4; ++i) {
      ASSERT_LT(glm::distance(pixel(dark[0], i), pixel(dark[1], i)), 1e-4f) << static_cast<int>(shading);
      ASSERT_LT(glm::distance(pixel(lit[1], i), pixel(dark[1], i)), 1e-4f);
      ambient = std::max(ambient, glm::distance(pixel(lit[0], i), pixel(lit[1], i)));
    }
    EXPECT_GT(ambient, 0.05f);
  }
}

TEST_F(AovFrames, ShadowIsTheShareOfLightThatIsLeft) {
  const FurredModel model = coarse(furred({Builtin::torus, 1000}));
  const auto images = aovs_of(model, small_frame(), {Aov::direct, Aov::shadow});
  double shares = 0, count = 0;
  for (std::size_t i = 0; i < images[0].rgba.size() / 4; ++i) {
    const float share = images[1].rgba[4 * i];
    ASSERT_TRUE(share >= 0 && share <= 1) << i;
    if (luminance(pixel(images[0], i)) < 0.05f) continue;
    ASSERT_GT(share, 0) << "light that nothing brings";
    shares += double{share}, ++count;
  }
  EXPECT_GT(count, 500);
  EXPECT_LT(shares / count, 0.95);
}

TEST_F(AovFrames, StrandsAreNamedWithTheirRoots) {
  const float length = 0.06f;
  const FurredModel model = coarse(furred({Builtin::sphere, 1000}, {.length = length, .inclination = 0.4}));
  FrameRequest request = small_frame();
  request.knobs.raster.strands = 4;
  const auto images = aovs_of(model, request, {Aov::strand, Aov::root, Aov::position, Aov::alpha});
  const double radius = 0.5 / std::sqrt(3.0);  // the bounding box's diagonal is 1
  std::map<float, glm::vec3> roots;
  int named = 0, near = 0;
  for (std::size_t i = 0; i < images[0].rgba.size() / 4; ++i) {
    const glm::vec3 strand = pixel(images[0], i), root = pixel(images[1], i);
    ASSERT_EQ(images[1].rgba[4 * i + 3], strand.x > 0 ? 1 : 0);
    ASSERT_TRUE(strand.x == 0 || images[3].rgba[4 * i + 3] > 0);
    if (strand.x == 0) continue;
    ++named;
    ASSERT_EQ(strand.x, std::floor(strand.x));
    ASSERT_TRUE(strand.y >= 0 && strand.y <= 1);
    ASSERT_EQ(strand.z, 1);
    ASSERT_NEAR(glm::length(root), radius, 0.01);
    ASSERT_EQ(roots.try_emplace(strand.x, root).first->second, root) << "one strand has one root";
    near += glm::distance(root, pixel(images[2], i)) < 1.2f * length;
  }
  EXPECT_GT(named, 3000);
  EXPECT_GT(near, 0.95 * named);  // positions at the rim mix in what lies behind
  EXPECT_GT(roots.size(), 500u);
}

TEST_F(AovFrames, StrandsAreNamedAlikeInAllFramesOfACoat) {
  const FurredModel model = coarse(furred({Builtin::sphere, 1000}, {.length = 0.06, .inclination = 0.4}));
  const auto roots_of = [&](AutoView view) {
    const auto images = aovs_of(model, small_frame(view), {Aov::strand, Aov::root});
    std::map<float, glm::vec3> roots;
    for (std::size_t i = 0; i < images[0].rgba.size() / 4; ++i)
      if (images[0].rgba[4 * i] > 0) roots[images[0].rgba[4 * i]] = pixel(images[1], i);
    return roots;
  };
  const auto front = roots_of(AutoView::front), side = roots_of(AutoView::three_quarter);
  int both = 0;
  for (const auto& [number, root] : side) {
    const auto found = front.find(number);
    if (found == front.end()) continue;
    ++both;
    EXPECT_EQ(found->second, root);
  }
  EXPECT_GT(both, 100);
}

TEST_F(AovFrames, BareSkinNamesNoStrand) {
  FurredModel model = coarse(furred({Builtin::sphere, 1000}, {.length = 0}));
  const auto images = aovs_of(model, small_frame(), {Aov::strand});
  for (std::size_t i = 0; i < images[0].rgba.size(); i += 4) ASSERT_EQ(images[0].rgba[i], 0);
}

TEST_F(AovFrames, CountTheSegments) {
  FurredModel model = furred({Builtin::plane, 200}, {.length = 0.05, .inclination = 0.3});
  FrameRequest request = small_frame(AutoView::top);
  const auto mean = [&](double strands) {
    request.knobs.raster.strands = strands;
    const FloatImage count = aovs_of(model, request, {Aov::sample_count})[0];
    double sum = 0;
    for (std::size_t i = 0; i < count.rgba.size(); i += 4) sum += double{count.rgba[i]};
    return sum / static_cast<double>(count.rgba.size() / 4);
  };
  const double few = mean(0.2), many = mean(1000);
  EXPECT_GT(few, 0.1);
  EXPECT_GT(many, 1.4 * few);
}

TEST_F(AovFrames, BeautyIsTheSameWithAndWithoutOthers) {
  const FurredModel model = coarse(furred({Builtin::creature, 2000}));
  FrameRequest request = small_frame();
  request.knobs.scale = 0.6;
  const auto alone = aovs_of(model, request, {Aov::beauty});
  const Image before = draw(*renderer, model, request);
  const auto together = aovs_of(model, request, {Aov::position, Aov::beauty, Aov::depth, Aov::sample_count});
  EXPECT_EQ(alone[0].rgba, together[1].rgba);
  EXPECT_EQ(before.rgba, draw(*renderer, model, request).rgba);
  for (const FloatImage& image : together) {
    EXPECT_TRUE(std::all_of(image.rgba.begin(), image.rgba.end(), [](float v) { return std::isfinite(v); }));
  }
}

TEST_F(AovFrames, SixteenBitsAreTheSamePictureWithMoreSteps) {
  const FurredModel model = coarse(furred({Builtin::creature, 2000}));
  const FrameRequest request = small_frame();
  const Image image = draw(*renderer, model, request);
  const Result<Image16> deep = renderer->draw_deep(make_frame(model.view(), request));
  ASSERT_TRUE(deep.ok());
  std::set<std::uint16_t> levels(deep->rgba.begin(), deep->rgba.end());
  EXPECT_GT(levels.size(), 1000u);
  for (std::size_t i = 0; i < image.rgba.size(); ++i) ASSERT_NEAR(deep->rgba[i] / 257.0, image.rgba[i], 0.51);
}

TEST_F(AovFrames, TheStudioIsDarkerInTheCornersAndHasNoBands) {
  const FurredModel model = coarse(furred({Builtin::sphere, 500}, {.length = 0.02}));
  FrameRequest request = small_frame(AutoView::front, 256);
  request.background = Background::studio;
  const Image image = draw(*renderer, model, request);
  const auto at = [&](int x, int y) { return int{image.rgba[4 * static_cast<std::size_t>(y * 256 + x)]}; };
  EXPECT_LT(at(2, 2), at(128, 6) - 5);
  EXPECT_LT(at(2, 253), at(128, 250) - 5);
  EXPECT_LT(at(128, 6), at(128, 250) - 20);
  int changes = 0, steps = 0;
  for (int x = 1; x < 256; ++x) {
    changes += at(x, 8) != at(x - 1, 8);
    steps = std::max(steps, std::abs(at(x, 8) - at(x - 1, 8)));
  }
  EXPECT_GT(changes, 60);  // banding would give only some tens of changes along a row
  EXPECT_LE(steps, 2);
  EXPECT_EQ(image.rgba, draw(*renderer, model, request).rgba);
}

TEST_F(AovFrames, OverlaysShowOnTheFurAlone) {
  const FurredModel model = coarse(furred({Builtin::sphere, 1000}, {.length = 0.04, .inclination = 0.8}));
  FrameRequest request = small_frame();
  const Image plain = draw(*renderer, model, request);
  std::set<std::vector<std::uint8_t>> pictures{plain.rgba};
  for (const Overlay overlay : {Overlay::direction, Overlay::strokes, Overlay::length, Overlay::wire}) {
    request.overlay = overlay;
    const Image image = draw(*renderer, model, request);
    EXPECT_GT(mean_difference(image, plain), 1) << static_cast<int>(overlay);
    EXPECT_EQ(image.rgba[3], overlay == Overlay::wire ? 255 : 0) << "alpha of the corner";
    EXPECT_EQ(image.rgba, draw(*renderer, model, request).rgba);
    pictures.insert(image.rgba);
  }
  EXPECT_EQ(pictures.size(), 5u);
}

/// The albedo is what fur of one colour reflects under any light, multiplied by alpha like the beauty.
TEST_F(AovFrames, AlbedoIsTheColourOfTheCoat) {
  FurredModel model = coarse(furred({Builtin::sphere, 1000}, {.length = 0.05, .inclination = 0.4}));
  const glm::vec3 colour(0.6f, 0.3f, 0.12f);
  model.settings.coats[0].coat.ramp = {{0, colour}};
  model.settings.coats[0].coat.colour_spread = 0;
  const auto lit = aovs_of(model, small_frame(), {Aov::albedo});
  for (std::size_t i = 0; i < lit[0].rgba.size() / 4; ++i) {
    ASSERT_LT(glm::distance(pixel(lit[0], i), colour * lit[0].rgba[4 * i + 3]), 0.015f);
  }
  model.settings.lights.clear();
  EXPECT_EQ(aovs_of(model, small_frame(), {Aov::albedo})[0].rgba, lit[0].rgba);
}

/// On the screen, hues go counter-clockwise: red to the right, then yellow, green, blue and violet.
TEST_F(AovFrames, HueTurnsWithTheDirectionOnTheScreen) {
  FurredModel model = coarse(furred({Builtin::plane, 200}, {.length = 0.02, .inclination = 0}));
  model.settings.coats[0].coat.ramp = {{0, glm::vec3(0.2f)}};
  FrameRequest request = small_frame(AutoView::top);
  request.overlay = Overlay::direction;
  request.background = Background::colour;
  const Mesh& mesh = model.model.surface.mesh();
  const FurCamera camera = make_frame(model.view(), request).camera;
  for (int turn = 0; turn < 6; ++turn) {
    const float angle = glm::radians(60.0f * static_cast<float>(turn));
    const glm::vec3 lean = std::cos(angle) * camera.right + std::sin(angle) * camera.up;
    for (std::uint32_t v = 0; v < model.fields.size(); ++v) {
      const glm::vec3 bitangent = glm::cross(mesh.normals[v], mesh.tangents[v]);
      Groom groom = model.fields.at(v);
      groom.direction = 0.99f * glm::vec2(glm::dot(lean, mesh.tangents[v]), glm::dot(lean, bitangent));
      model.fields.set(v, groom);
    }
    const glm::dvec3 shown = mean_colour(draw(*renderer, model, request));
    // Red, yellow, green, cyan, blue and violet at 0, 60, ... 300 degrees.
    const glm::dvec3 pure[] = {{1, 0, 0}, {1, 1, 0}, {0, 1, 0}, {0, 1, 1}, {0, 0, 1}, {1, 0, 1}};
    for (int a = 0; a < 3; ++a) {
      for (int b = 0; b < 3; ++b) EXPECT_GT(shown[a], shown[b] + (pure[turn][a] > pure[turn][b] ? 40 : -255)) << turn;
    }
  }
}

/// Strokes run along the fur, so the picture changes less along them than across.
TEST_F(AovFrames, StrokesRunAlongTheFur) {
  const FurredModel model = coarse(furred({Builtin::plane, 200}, {.length = 0.02, .inclination = 1}));
  FrameRequest request = small_frame(AutoView::top, 192);
  request.background = Background::colour;
  const Image plain = draw(*renderer, model, request);
  request.overlay = Overlay::strokes;
  const Image image = draw(*renderer, model, request);
  const auto stroke = [&](int x, int y) {
    const std::size_t i = 4 * static_cast<std::size_t>(y * image.width + x);
    return double(image.rgba[i] - plain.rgba[i]);
  };
  double across = 0, along = 0;
  for (int y = 64; y < 128; ++y) {
    for (int x = 64; x < 128; ++x) {
      across += std::abs(stroke(x + 1, y) - stroke(x, y)), along += std::abs(stroke(x, y + 1) - stroke(x, y));
    }
  }
  const Mesh& mesh = model.model.surface.mesh();
  const FurCamera camera = make_frame(model.view(), request).camera;
  const glm::vec2 direction = model.fields.at(0).direction;
  const glm::vec3 lean = direction.x * mesh.tangents[0] + direction.y * glm::cross(mesh.normals[0], mesh.tangents[0]);
  const bool level = std::abs(glm::dot(lean, camera.right)) > std::abs(glm::dot(lean, camera.up));
  EXPECT_GT(level ? along : across, 1.8 * (level ? across : along));
}

TEST_F(AovFrames, HueFollowsTheDirection) {
  const FurredModel lying = coarse(furred({Builtin::plane, 200}, {.length = 0.03, .inclination = 1}));
  const FurredModel standing = coarse(furred({Builtin::plane, 200}, {.length = 0.03, .inclination = 0}));
  FrameRequest request = small_frame(AutoView::top);
  request.overlay = Overlay::direction;
  request.background = Background::colour;
  const glm::dvec3 first = mean_colour(draw(*renderer, lying, request));
  const glm::dvec3 upright = mean_colour(draw(*renderer, standing, request));
  const auto spread = [](glm::dvec3 c) { return std::max({c.r, c.g, c.b}) - std::min({c.r, c.g, c.b}); };
  EXPECT_GT(spread(first), spread(upright) + 20);
}

/// A bare sphere of radius .289 with an eye in front of its middle.
FurredModel with_eye() {
  FurredModel model = coarse(furred({Builtin::sphere, 1000}, {.length = 0}));
  model.settings.eyes = {{.position = model.model.surface.mesh().to_model({0, 0, 0.25}), .radius = 0.1}};
  return model;
}

TEST_F(AovFrames, HoldEyes) {
  const FurredModel model = with_eye();
  FrameRequest request = small_frame();
  const FurFrame frame = make_frame(model.view(), request);
  const auto images = aovs_of(
      model, request,
      {Aov::depth, Aov::position, Aov::normal, Aov::albedo, Aov::direct, Aov::beauty, Aov::shadow, Aov::tangent});
  const glm::vec3 centre = frame.eyes[0].position;
  int seen = 0;
  for (std::size_t i = 0; i < images[0].rgba.size() / 4; ++i) {
    const glm::vec3 position = pixel(images[1], i);
    if (glm::distance(position, centre) > 1.01f * frame.eyes[0].radius ||
        position.z < centre.z + 0.5f * frame.eyes[0].radius)
      continue;
    ++seen;
    EXPECT_NEAR(1 / images[0].rgba[4 * i], glm::dot(position - frame.camera.position, frame.camera.forward), 1e-4);
    EXPECT_GT(glm::dot(pixel(images[2], i), glm::normalize(position - centre)), 0.8f);
    EXPECT_EQ(pixel(images[7], i), glm::vec3(0));
    EXPECT_NEAR(images[6].rgba[4 * i], 1, 1e-4);
    const glm::vec3 direct = pixel(images[4], i), beauty = pixel(images[5], i);
    for (int k = 0; k < 3; ++k) EXPECT_LE(direct[k], beauty[k] + 1e-4f);
  }
  EXPECT_GT(seen, 200);
}

TEST_F(AovFrames, WithoutAmbientAnEyesLightIsDirect) {
  FurredModel model = with_eye();
  model.settings.look.ambient = 0;
  FrameRequest request = small_frame();
  request.background_colour = glm::vec3(0);  // the cornea reflects it
  const auto images = aovs_of(model, request, {Aov::beauty, Aov::direct});
  for (std::size_t i = 0; i < images[0].rgba.size() / 4; ++i)
    ASSERT_LT(glm::distance(pixel(images[0], i), pixel(images[1], i)),
              2e-3f);  // highlight edges are steep, and the two programs round differently
}

TEST_F(AovFrames, HoldCurves) {
  FurredModel model = coarse(furred({Builtin::sphere, 1000}, {.length = 0.02}));
  const Mesh& mesh = model.model.surface.mesh();
  CurveGroup group;
  group.curves = {{mesh.to_model({-0.1, 0, 0.4}), mesh.to_model({0.1, 0, 0.4})}};
  group.width_root = group.width_tip = 0.02;
  group.root_colour = group.tip_colour = {0.1f, 0.9f, 0.1f};
  model.settings.curves = {group};
  model.settings.lights = {{.direction = {0, 0, -1}}};
  const FrameRequest request = small_frame();
  const FurFrame frame = make_frame(model.view(), request);
  const auto images = aovs_of(
      model, request, {Aov::depth, Aov::position, Aov::tangent, Aov::albedo, Aov::shadow, Aov::direct, Aov::beauty});
  int seen = 0;
  for (std::size_t i = 0; i < images[0].rgba.size() / 4; ++i) {
    const glm::vec3 albedo = pixel(images[3], i), position = pixel(images[1], i);
    if (images[3].rgba[4 * i + 3] < 0.99f || position.z < 0.39f) continue;  // other pixels mix in what lies behind
    ++seen;
    EXPECT_NEAR(albedo.g, 0.9f, 0.02);
    EXPECT_NEAR(position.z, 0.4f, 0.005);
    EXPECT_NEAR(1 / images[0].rgba[4 * i], glm::dot(position - frame.camera.position, frame.camera.forward), 0.01);
    EXPECT_GT(std::abs(pixel(images[2], i).x), 0.99f);
    EXPECT_GT(images[5].rgba[4 * i + 1], 0);
    EXPECT_NEAR(images[4].rgba[4 * i], 1, 0.02);  // nothing shadows it
  }
  EXPECT_GT(seen, 20);
}

}  // namespace
}  // namespace pelage::testing::aovs_test
