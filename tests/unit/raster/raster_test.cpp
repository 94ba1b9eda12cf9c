// Whole pictures of a patch of fur: equal bits, coverage and extremes.
#include "renderer/raster/raster.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numeric>
#include <vector>

#include "renderer/raster/kernels.h"
#include "tests/unit/strands/fur_patch.h"

namespace pelage {
namespace {

/// A lawn seen from above at a slant.
struct Stage {
  FurPatch patch{0.4, 8, 0.05f};
  GrowRecipe recipe{plain_coat(4000)};
  GrownFur fur;
  FurFrame frame;

  Stage() {
    frame.width = 96, frame.height = 80;
    look_from({0.2f, -0.5f, 0.6f}, {0.2f, 0.2f, 0});
    frame.coat() = recipe.coat;
    FurLight key, fill;
    key.direction = glm::normalize(glm::vec3(0.3f, 0.5f, -1)), fill.direction = {-1, 0, 0};
    frame.lights = {key, fill};
    grow();
  }
  void grow() { fur.update(patch.model(), patch.fields(), recipe, 2); }
  void look_from(glm::vec3 position, glm::vec3 target) {
    FurCamera& camera = frame.camera;
    camera.position = position, camera.forward = glm::normalize(target - position);
    camera.right = glm::normalize(glm::cross(camera.forward, glm::vec3(0, 0, 1)));
    camera.up = glm::cross(camera.right, camera.forward), camera.tan_half_fov = 0.3f;
  }
  FloatImage draw(const RasterQuality& quality = {}, int threads = 2, RasterCounts* counts = nullptr) const {
    Raster raster(threads);
    return raster.draw(patch.model(), fur, frame, quality, counts);
  }
};

bool is_sound(const FloatImage& image) {
  return std::all_of(image.rgba.begin(), image.rgba.end(), [](float v) { return std::isfinite(v) && v >= 0; });
}

double mean(const FloatImage& image, std::size_t channel) {
  double sum = 0;
  for (std::size_t i = channel; i < image.rgba.size(); i += 4) sum += double{image.rgba[i]};
  return sum / static_cast<double>(image.rgba.size() / 4);
}

glm::vec4 pixel(const FloatImage& image, int x, int y) {
  const float* at = &image.rgba[4 * static_cast<std::size_t>(y * image.width + x)];
  return {at[0], at[1], at[2], at[3]};
}

TEST(Raster, HasTheSameBitsForAnyThreads) {
  const Stage stage;
  for (const RasterQuality& quality : {RasterQuality{100, 1}, RasterQuality{1, 4}})
    EXPECT_EQ(stage.draw(quality, 1).rgba, stage.draw(quality, 7).rgba);
}

/// Number of pixels inside a crop that differ.
int other_pixels(const FloatImage& whole, const FloatImage& image, const Crop& crop) {
  int count = 0;
  for (int y = crop.top; y < crop.top + crop.height; ++y)
    for (int x = crop.left; x < crop.left + crop.width; ++x) count += pixel(whole, x, y) != pixel(image, x, y) ? 1 : 0;
  return count;
}

/// A lawn in one light from the side, seen from so near that the picture shows only a small part.
struct NearLawn : Stage {
  NearLawn() {
    recipe = {plain_coat(3000)};
    frame.coat() = recipe.coat, frame.lights.resize(1);
    frame.lights[0].direction = glm::normalize(glm::vec3(1, 0.3f, -0.7f));
    grow();
    look_from({0.2f, 0.1f, 0.5f}, {0.2f, 0.2f, 0.02f});
    frame.width = frame.height = 160, frame.camera.tan_half_fov = 0.08f;
  }
};

TEST(Raster, ACropHasTheBitsOfTheWhole) {
  Stage stage;
  stage.frame.width = 320, stage.frame.height = 280;
  std::fill(stage.patch.length.begin() + 20, stage.patch.length.begin() + 50, 0.2f);
  for (std::size_t i = 0; i < stage.patch.positions.size(); ++i)  // a hill, with fur behind it
    stage.patch.positions[i].z = 0.2f * std::exp(-40 * std::pow(stage.patch.positions[i].y - 0.2f, 2.0f));
  stage.frame.ground = FurGround{.height = -0.4f, .shadow = 1, .contact = 1};
  stage.grow();
  for (const RasterQuality& quality : {RasterQuality{1000, 1}, RasterQuality{1, 4}}) {
    stage.frame.crop.reset();
    const FloatImage whole = stage.draw(quality);
    for (const Crop& crop : {Crop{37, 50, 90, 61}, Crop{160, 130, 1, 1}, Crop{0, 96, 320, 16}, Crop{5, 5, 310, 270}}) {
      stage.frame.crop = crop;
      EXPECT_EQ(other_pixels(whole, stage.draw(quality), crop), 0) << crop.left;
    }
  }
  NearLawn lawn;
  const FloatImage whole = lawn.draw();
  lawn.frame.crop = Crop{30, 60, 50, 40};
  EXPECT_EQ(other_pixels(whole, lawn.draw(), *lawn.frame.crop), 0);
}

struct LightSpread {
  double mean = 0, deviation = 0;
};

/// Mean and deviation of the light halfway up the strands of a part.
LightSpread light_spread(const RasterScene& scene, const GrownPart& part) {
  std::vector<std::uint32_t> ids(part.strands->count());
  std::iota(ids.begin(), ids.end(), 0);
  LitPoints light;
  light_strands(scene, part, ids, true, light);
  const auto count = static_cast<std::size_t>(light.count);
  double sum = 0, squares = 0;
  for (std::size_t i = 0; i < ids.size(); ++i) {
    const double red = light.light[i * count + count / 2].r;
    sum += red, squares += red * red;
  }
  const double mean = sum / static_cast<double>(ids.size());
  return {mean, std::sqrt(std::max(squares / static_cast<double>(ids.size()) - mean * mean, 0.0))};
}

TEST(Raster, SingleStrandsThrowShadowsWhereTheCameraIsNear) {
  const NearLawn lawn;
  Raster raster(2);
  const FurModel model = lawn.patch.model();
  RasterScene near = raster.scene_of(model, lawn.fur, lawn.frame, {1000, 1}, RasterOutput::light);
  raster.fill_cells(near);
  ASSERT_FALSE(near.near->cells().empty());
  RasterScene mean = near;
  mean.near = nullptr;
  const auto middle = std::min_element(near.parts.begin(), near.parts.end(), [](const auto& a, const auto& b) {
    return glm::distance(a.middle, glm::vec3(0.2f, 0.2f, 0)) < glm::distance(b.middle, glm::vec3(0.2f, 0.2f, 0));
  });
  const LightSpread one = light_spread(near, *middle), other = light_spread(mean, *middle);
  EXPECT_GT(one.deviation, 1.5 * other.deviation);
  EXPECT_NEAR(one.mean, other.mean, 0.1 * other.mean);
}

TEST(Raster, FewStrandsCoverAndShineAsAll) {
  const Stage stage;
  const FloatImage all = stage.draw({1000, 1});
  EXPECT_TRUE(is_sound(all));
  EXPECT_GT(mean(all, 3), 0.3);
  for (const RasterQuality& quality : {RasterQuality{1000, 1}, RasterQuality{1000, 2}, RasterQuality{3, 1}}) {
    RasterCounts counts;
    const FloatImage few = stage.draw(quality, 2, &counts);
    EXPECT_LT(counts.lit, counts.strands + 1);
    EXPECT_NEAR(mean(few, 3), mean(all, 3), 0.015 * mean(all, 3));
    EXPECT_NEAR(mean(few, 1), mean(all, 1), 0.06 * mean(all, 1));
  }
}

/// The strands that are seen are taller than those whose light they share.
TEST(Raster, SharedLightIsThatOfTheSameHeight) {
  Stage stage;
  stage.recipe.coat.length_spread = 0.8, stage.recipe.coat.count = 20000, stage.frame.coat() = stage.recipe.coat;
  stage.grow();
  const double own = mean(stage.draw({1000, 1}), 1);
  for (const int lit_of : {2, 4, 8}) EXPECT_NEAR(mean(stage.draw({1000, lit_of}), 1), own, 0.015 * own) << lit_of;
}

TEST(Raster, StrandsThatAreSeenSinglyAreLitThemselves) {
  Stage stage;
  RasterCounts far, near;
  stage.draw({1000, 4}, 2, &far);
  EXPECT_LT(far.lit, far.placed / 2);
  stage.frame.camera.tan_half_fov *= 0.02f;
  stage.draw({1000, 4}, 2, &near);
  EXPECT_GT(near.placed, 10u);
  EXPECT_EQ(near.lit, near.placed);
}

// In a fine mesh few triangles contain a pixel's centre, but together they leave no hole.
TEST(Raster, SkinIsWholeHoweverFineItsMesh) {
  const auto bald = [](int quads) {
    Stage stage;
    stage.patch = FurPatch{0.4, quads, 0};
    stage.patch.id = 2;
    stage.grow();
    return stage.draw();
  };
  const FloatImage coarse = bald(1), fine = bald(200);  // triangles of a third of a pixel
  EXPECT_GT(mean(coarse, 3), 0.2);
  for (std::size_t i = 3; i < coarse.rgba.size(); i += 4) ASSERT_EQ(fine.rgba[i], coarse.rgba[i]) << i / 4;
}

TEST(Raster, IsSoundWhereNothingCanBeDrawn) {
  Stage stage;
  stage.frame.width = stage.frame.height = 1;
  EXPECT_TRUE(is_sound(stage.draw()));
  stage.frame.width = 33, stage.frame.height = 17;  // not a multiple of the tile size
  stage.frame.lights.clear();
  EXPECT_TRUE(is_sound(stage.draw()));
  stage.look_from({0.2f, 0.2f, 0.02f}, {0.2f, 0.3f, 0.02f});  // inside the fur
  EXPECT_TRUE(is_sound(stage.draw()));
  stage.look_from({0.2f, 0.2f, 1}, {0.2f, 0.5f, 2});  // with the lawn behind the camera
  EXPECT_EQ(mean(stage.draw(), 3), 0);
}

TEST(Raster, IsSoundWithStrandsOfAnySize) {
  for (const float length : {0.0f, 1e-6f, 10.0f}) {
    for (const float size : {1.0f, 1e-4f}) {
      Stage stage;
      std::fill(stage.patch.length.begin(), stage.patch.length.end(), length);
      stage.grow();
      stage.frame.camera.tan_half_fov *= size;  // at least a million pixels long
      EXPECT_TRUE(is_sound(stage.draw({1, 1}))) << length;
    }
  }
}

TEST(Raster, CurlsAreDrawn) {
  Stage stage;
  stage.recipe.coat.curl = 0.2, stage.recipe.coat.curl_turns = 5;
  stage.frame.coat() = stage.recipe.coat;
  stage.grow();
  ASSERT_GT(stage.fur.parts()[0].strands->segments, 30);
  const FloatImage all = stage.draw({1000, 1}), few = stage.draw({1000, 2});
  EXPECT_TRUE(is_sound(all));
  EXPECT_NEAR(mean(few, 3), mean(all, 3), 0.02 * mean(all, 3));
}

TEST(Raster, CurvesAreDrawnWholeHoweverFewStrandsAre) {
  Stage stage;
  std::fill(stage.patch.length.begin(), stage.patch.length.end(), 0.0f);
  FurCurves whiskers;
  for (const double y : {0.06, 0.1, 0.14, 0.18, 0.22, 0.26, 0.3, 0.34})
    whiskers.guides.push_back({.points = {{0.1, y, 0.01}, {0.3, y, 0.01}}, .normal = {0, 0, 1}});
  whiskers.width_root = whiskers.width_tip = 0.006, whiskers.root_colour = whiskers.tip_colour = glm::vec3(1, 0, 0);
  const auto seen = [&](const RasterQuality& quality) {  // counts curves down the middle of the picture
    const FloatImage image = stage.draw(quality);
    EXPECT_TRUE(is_sound(image));
    int count = 0;
    bool before = false;
    for (int y = 0; y < image.height; ++y) {
      const glm::vec4 of = pixel(image, image.width / 2, y);
      const bool red = of.r > 4 * of.g;
      count += red && !before ? 1 : 0, before = red;
    }
    return count;
  };
  stage.grow();
  EXPECT_EQ(seen({1, 1}), 0);
  stage.fur.update(stage.patch.model(), stage.patch.fields(), stage.recipe, 2, std::array{whiskers});
  EXPECT_EQ(seen({1000, 1}), 8);
  EXPECT_EQ(seen({0.001, 8}), 8);
}

TEST(Raster, SkinHidesStrandsBehindIt) {
  Stage stage;
  RasterCounts uncovered, covered;
  stage.draw({1000, 1}, 2, &uncovered);
  EXPECT_GT(uncovered.placed, uncovered.strands / 3);
  FurPatch& patch = stage.patch;  // a bald ceiling between the lawn and the camera
  const auto first = static_cast<unsigned>(patch.positions.size());
  for (const glm::vec2 corner : {glm::vec2(-2, -2), glm::vec2(2, -2), glm::vec2(2, 2), glm::vec2(-2, 2)}) {
    patch.positions.emplace_back(corner, 0.3f), patch.normals.emplace_back(0, 0, 1),
        patch.tangents.emplace_back(1, 0, 0);
    patch.direction.emplace_back(0), patch.length.push_back(0);
  }
  patch.add({first, first + 1, first + 2}), patch.add({first, first + 2, first + 3});
  patch.id = 2;
  stage.grow();
  const FloatImage ceiling = stage.draw({1000, 1}, 2, &covered);
  EXPECT_EQ(covered.strands, uncovered.strands);
  EXPECT_EQ(covered.placed, 0u);
  EXPECT_EQ(mean(ceiling, 3), 1);
}

TEST(Raster, AnEyeHidesWhatIsBehindItAndNothingElse) {
  Stage stage;
  const FloatImage none = stage.draw({1000, 1});
  FurEye eye;
  eye.radius = 0.08f, eye.sclera = {0, 1, 0}, eye.frame = glm::mat3(-1, 0, 0, 0, 0, 1, 0, 1, 0);  // looks away
  eye.position = {0.2f, 0.35f, -0.12f};
  stage.frame.eyes = {eye};
  EXPECT_EQ(stage.draw({1000, 1}).rgba, none.rgba);  // under the skin
  RasterCounts without_eye, with_eye;
  stage.frame.eyes[0].position = {0.2f, -0.1f, 0.3f};  // between the lawn and the camera
  stage.draw({1000, 1}, 2, &with_eye);
  stage.frame.eyes.clear();
  stage.draw({1000, 1}, 2, &without_eye);
  EXPECT_LT(with_eye.placed, without_eye.placed);
  stage.frame.eyes = {eye};
  stage.frame.eyes[0].position = {0.42f, 0.2f, 0.1f};  // partly in front of nothing
  const FloatImage seen = stage.draw({1000, 1}), again = stage.draw({1000, 1}, 7);
  EXPECT_TRUE(is_sound(seen));
  EXPECT_EQ(seen.rgba, again.rgba);
  std::size_t green = 0;
  for (int i = 0; i < seen.width * seen.height; ++i) {
    const glm::vec4 of = pixel(seen, i % seen.width, i / seen.width);
    if (of.g > 2 * of.r && of.a > 0.99f) ++green;
  }
  EXPECT_GT(green, 200u);
}

TEST(Raster, SkinWithoutFurShowsTheModelsPicture) {
  constexpr std::array<std::uint8_t, 8> red_and_blue{255, 0, 0, 255, 0, 0, 255, 255};
  Stage stage;
  std::fill(stage.patch.length.begin(), stage.patch.length.end(), 0.0f);
  stage.patch.images = {{2, 1, red_and_blue}};
  for (auto& corners : stage.patch.corners)
    for (FurCorner& corner : corners) corner.image = 0, corner.image_uv.x *= 2.5f;  // one repeat across the lawn
  FurModel model = stage.patch.model();
  model.has_colours = true;
  stage.recipe.model_colours = true;
  stage.fur.update(model, stage.patch.fields(), stage.recipe, 2);
  Raster raster(2);
  const FloatImage image = raster.draw(model, stage.fur, stage.frame, {});
  EXPECT_GT(pixel(image, 33, 40).r, 10 * pixel(image, 33, 40).b) << "in the middle of a texel";
  EXPECT_GT(pixel(image, 62, 40).b, 10 * pixel(image, 62, 40).r);
}

TEST(Raster, WhatIsPaintedBareIsSkin) {
  Stage stage;
  const double covered = mean(stage.draw(), 1);
  const std::vector<float> bare(stage.patch.positions.size(), 1);
  stage.patch.paint.bare = bare;
  stage.grow();
  EXPECT_EQ(stage.fur.count(), 0u);
  const FloatImage skin = stage.draw();
  EXPECT_TRUE(is_sound(skin));
  std::fill(stage.patch.length.begin(), stage.patch.length.end(), 0.0f);
  stage.patch.paint.bare = {};
  stage.grow();
  const FloatImage bald = stage.draw();
  EXPECT_GT(std::abs(pixel(skin, 48, 40).g - pixel(bald, 48, 40).g), 0.01f) << "it shines, and is not matt";
  EXPECT_GT(std::abs(covered - mean(skin, 1)), 0.01);
}

TEST(Raster, BareSkinHasTheColourOfItsRegion) {
  Stage stage;
  std::fill(stage.patch.length.begin(), stage.patch.length.end(), 0.0f);
  stage.grow();
  const glm::vec4 furred = pixel(stage.draw(), 48, 40);
  FurSkinRegion nose;
  nose.centre = {0.2, 0.2, 0}, nose.to_unit = glm::dmat3(4), nose.softness = 0.1;  // a ball of radius .25
  nose.colour = {0.8f, 0.05f, 0.05f}, nose.shine = 0;
  stage.frame.skin = {nose};
  const FloatImage bare = stage.draw();
  const glm::vec4 middle = pixel(bare, 48, 40);
  EXPECT_NEAR(furred.r, furred.g, 0.7f * furred.r);
  EXPECT_GT(middle.r, 8 * middle.g);
  EXPECT_EQ(middle.a, 1);
}

/// The lawn as a wall that stands on the ground, seen from above.
struct Wall : Stage {
  Wall() {
    look_from({0.2f, 3, 0.001f}, {0.2f, 0, 0});
    frame.ground = FurGround{.height = 0, .shadow = 1, .contact = 1};
    frame.lights.resize(1), frame.lights[0].direction = glm::normalize(glm::vec3(0, -1, -1));
  }
  float dark(const FloatImage& image, glm::vec3 position) const {
    const FurCamera& camera = frame.camera;
    const glm::vec3 apart = position - camera.position;
    const float scale = 0.5f * static_cast<float>(frame.height) / camera.tan_half_fov / glm::dot(apart, camera.forward);
    return pixel(image, frame.width / 2 + static_cast<int>(glm::dot(apart, camera.right) * scale),
                 frame.height / 2 - static_cast<int>(glm::dot(apart, camera.up) * scale))
        .a;
  }
};

TEST(Raster, TheGroundIsDarkWhereLightIsMissing) {
  Wall wall;
  wall.frame.look.ambient = 0;
  const FloatImage image = wall.draw();
  EXPECT_TRUE(is_sound(image));
  EXPECT_GT(wall.dark(image, {0.2f, 0, -0.2f}), 0.9f) << "behind the wall, which is as high as its shadow is long";
  EXPECT_LT(wall.dark(image, {0.2f, 0, 0.3f}), 0.02f) << "before it";
  EXPECT_LT(wall.dark(image, {0.2f, 0, -0.6f}), 0.02f) << "beyond its shadow";
  EXPECT_LT(wall.dark(image, {0.6f, 0, -0.2f}), 0.02f) << "beside it";
  wall.frame.lights[0].angle = 0.2f;
  const FloatImage soft = wall.draw();
  EXPECT_GT(wall.dark(soft, {0.2f, 0, -0.1f}), 0.9f);
  EXPECT_NEAR(wall.dark(soft, {0.2f, 0, -0.4f}), 0.5f, 0.2f) << "half of the light is past the edge";
  EXPECT_EQ(soft.rgba, wall.draw({}, 7).rgba);
  wall.look_from({0.2f, -3, 0.001f}, {0.2f, 0, 0});
  EXPECT_EQ(wall.dark(wall.draw(), {0.2f, 0, -0.2f}), 0) << "from below there is no ground";
}

TEST(Raster, AWallHidesTheSky) {
  Wall wall;
  wall.frame.lights.clear();
  wall.frame.width = wall.frame.height = 480;
  const FloatImage image = wall.draw();
  EXPECT_NEAR(wall.dark(image, {0.2f, 0, -0.03f}), 0.44f, 0.06f) << "of rays to a matt sky";
  EXPECT_NEAR(wall.dark(image, {0.2f, 0, -0.2f}), 0.19f, 0.03f);
  EXPECT_EQ(wall.dark(image, {0.2f, 0, -0.7f}), 0);
}

}  // namespace
}  // namespace pelage
