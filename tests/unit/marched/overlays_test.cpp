// What overlays show of a square whose fields are known.
#include <gtest/gtest.h>

#include <numeric>

#include "renderer/marched/field_overlay.h"
#include "renderer/marched/fur_hull.h"
#include "renderer/marched/light_map_overlay.h"
#include "renderer/marched/shape_overlay.h"

namespace pelage {
namespace {

constexpr int picture_side = 64;

/// Across the view and half as wide, its right side 1 long and its left side bare. A second one may stand before it.
struct Squares {
  std::vector<glm::vec3> positions, normals, tangents, groom;
  std::vector<float> mask;
  std::vector<std::uint32_t> welded;
  std::vector<glm::uvec3> triangles;

  void add(float half, float z, glm::vec2 direction = {0, 0}) {
    const auto first = static_cast<std::uint32_t>(positions.size());
    for (const glm::vec2 corner : {glm::vec2(-1, -1), glm::vec2(1, -1), glm::vec2(1, 1), glm::vec2(-1, 1)}) {
      positions.emplace_back(half * corner, z);
      normals.emplace_back(0, 0, 1), tangents.emplace_back(1, 0, 0);
      groom.emplace_back(direction, corner.x > 0 ? 1.0f : 0.0f);
      mask.push_back(corner.x > 0 ? 1.0f : 0.0f);
    }
    welded.resize(positions.size());
    std::iota(welded.begin(), welded.end(), 0u);
    triangles.emplace_back(first, first + 1, first + 2), triangles.emplace_back(first, first + 2, first + 3);
  }
  MarchMesh mesh() const {
    MarchMesh view;
    view.positions = positions, view.normals = normals, view.tangents = tangents, view.groom = groom;
    view.mask = mask, view.welded = welded, view.triangles = triangles;
    return view;
  }
};

FurFrame frame_of(Overlay overlay) {
  FurFrame frame;
  frame.camera = {.position = {0, 0, 2}, .tan_half_fov = 0.5f};
  frame.width = frame.height = picture_side;
  frame.overlay = overlay;
  return frame;
}

glm::vec4 pixel(const FloatImage& image, int x, int y) {
  const float* at = &image.rgba[4 * static_cast<std::size_t>(y * image.width + x)];
  return {at[0], at[1], at[2], at[3]};
}

void expect_colour(const FloatImage& image, int x, int y, glm::vec4 expected, float apart) {
  for (int k = 0; k < 4; ++k) EXPECT_NEAR(pixel(image, x, y)[k], expected[k], apart) << "channel " << k;
}

Squares one_square(glm::vec2 direction = {0, 0}) {
  Squares squares;
  squares.add(0.5f, 0, direction);
  return squares;
}

const glm::vec4 least(0.267f, 0.005f, 0.329f, 0.6f), half(0.128f, 0.567f, 0.551f, 0.6f),
    most(0.993f, 0.906f, 0.144f, 0.6f), nothing(0);

/// The square covers pixels 16 to 48; the middle of pixel 47 is a 64th of its width from the side.
TEST(Overlays, LengthsAndMasksRunFromVioletToYellow) {
  const Squares square = one_square();
  for (const Overlay overlay : {Overlay::length, Overlay::mask}) {
    const FloatImage image = field_overlay(frame_of(overlay), square.mesh(), 2);
    expect_colour(image, 16, 32, least, 0.03f);
    expect_colour(image, 32, 20, half, 0.03f);
    expect_colour(image, 47, 40, most, 0.05f);
    for (const glm::ivec2 beside : {glm::ivec2(15, 32), glm::ivec2(48, 32), glm::ivec2(32, 15), glm::ivec2(32, 48)})
      expect_colour(image, beside.x, beside.y, nothing, 0);
  }
}

TEST(Overlays, DirectionsAreHues) {
  const auto shown = [](glm::vec2 direction) {
    return pixel(field_overlay(frame_of(Overlay::direction), one_square(direction).mesh(), 1), 32, 32);
  };
  const auto expect_hue = [&](glm::vec2 direction, glm::vec3 hue) {
    for (int k = 0; k < 3; ++k)
      EXPECT_NEAR(shown(direction)[k], hue[k], 0.02f) << direction.x << ", " << direction.y << " channel " << k;
  };
  expect_hue({0.8f, 0}, {1, 0.2f, 0.2f});  // to the right: red
  expect_hue({0, 0.8f}, {0.6f, 1, 0.2f});  // up: green, half way to yellow
  expect_hue({-0.8f, 0}, {0.2f, 1, 1});    // to the left: blue and green
  expect_hue({0, 0}, {1, 1, 1});           // upright: white
}

TEST(Overlays, DifferencesAreGreyWhereNothingChanged) {
  const Squares square = one_square();
  FurFrame frame = frame_of(Overlay::difference);
  frame.difference = {0, 0, 0, 0};
  expect_colour(field_overlay(frame, square.mesh(), 1), 32, 32, {0.5f, 0.5f, 0.5f, 0.6f}, 0);
  frame.difference = {1, 1, 1, 1};
  expect_colour(field_overlay(frame, square.mesh(), 1), 32, 32, most, 1e-5f);
}

/// What stands nearer hides what lies behind it, whichever comes first.
TEST(Overlays, TheNearestIsShown) {
  for (const bool near_first : {false, true}) {
    Squares squares;
    squares.add(near_first ? 0.2f : 0.5f, near_first ? 0.5f : 0.0f, near_first ? glm::vec2(0.8f, 0) : glm::vec2(0));
    squares.add(near_first ? 0.5f : 0.2f, near_first ? 0.0f : 0.5f, near_first ? glm::vec2(0) : glm::vec2(0.8f, 0));
    const FloatImage image = field_overlay(frame_of(Overlay::direction), squares.mesh(), 2);
    EXPECT_NEAR(pixel(image, 32, 32).g, 0.2f, 0.02f) << near_first;
    EXPECT_NEAR(pixel(image, 18, 32).g, 1, 0.02f) << near_first;
  }
}

/// The square's diagonal runs from its lower left to its upper right corner; skin that is front-facing is lightest.
TEST(Overlays, TheShapeHidesTheFrame) {
  const Squares square = one_square();
  const FloatImage bald = shape_overlay(frame_of(Overlay::bald), square.mesh(), 2);
  const FloatImage wire = shape_overlay(frame_of(Overlay::wire), square.mesh(), 1);
  for (const glm::ivec2 on : {glm::ivec2(32, 31), glm::ivec2(24, 28)}) EXPECT_GT(pixel(bald, on.x, on.y).r, 0.8f);
  EXPECT_LT(pixel(bald, 2, 2).r, 0.3f);
  for (int i = 3; i < picture_side * picture_side * 4; i += 4) ASSERT_EQ(bald.rgba[static_cast<std::size_t>(i)], 1);
  EXPECT_EQ(pixel(wire, 24, 28), pixel(bald, 24, 28)) << "within a triangle";
  int edges = 0;
  for (int x = 17; x < 47; ++x) edges += pixel(wire, x, 40) != pixel(bald, x, 40) ? 1 : 0;
  EXPECT_TRUE(edges == 1 || edges == 2) << edges;
  EXPECT_NE(pixel(wire, 15, 40), pixel(bald, 15, 40)) << "the silhouette";
}

/// Depths run from white at the near side of the ball around the model to black at its far side.
TEST(Overlays, DepthsOfALightAreGreysOverTheModelsBall) {
  Squares squares;
  squares.add(0.5f, -0.2f), squares.add(0.2f, 0.3f);
  FurFrame frame = frame_of(Overlay::light_depth);
  frame.lights = {{.direction = {0, 0, -1}, .cast_shadow = CastShadow::hard}};
  EXPECT_FALSE(light_map_overlay(frame, squares.mesh(), 1));  // no tier that draws maps
  frame.knobs.shadow_maps = true, frame.knobs.shadow_resolution = 64;
  const std::optional<FloatImage> image = light_map_overlay(frame, squares.mesh(), 1);
  ASSERT_TRUE(image);
  const float radius = radius_of_fur(squares.mesh());
  const float near = (radius + 0.3f) / (2 * radius), far = (radius - 0.2f) / (2 * radius);
  expect_colour(*image, 32, 32, {near, near, near, 1}, 1e-3f);
  expect_colour(*image, 32, 22, {far, far, far, 1}, 1e-3f);
  expect_colour(*image, 0, 0, {0, 0, 0, 1}, 1e-6f);
}

}  // namespace
}  // namespace pelage
