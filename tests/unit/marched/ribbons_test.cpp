// Ribbons of guided curves on a picture.
#include "renderer/marched/ribbons.h"

#include <gtest/gtest.h>

#include "renderer/upload/blocks.h"

namespace pelage {
namespace {

constexpr float size = 256;

RibbonCamera camera() {
  FurFrame frame;
  frame.camera = {.position = {0, 0, 2}, .tan_half_fov = 0.3f};
  frame.width = frame.height = static_cast<int>(size);
  return {world_to_clip(frame), frame.camera.position, 2 * 0.3f / size, {size, size}};
}

/// An arc across the picture, so wide.
std::vector<Ribbon> arc(double width) {
  FurCurves group;
  FurGuide guide;
  for (const double x : {-0.4, -0.2, 0.0, 0.2, 0.4}) guide.points.push_back({x, 1.5 * x * x - 0.1, 0});
  group.guides = {guide}, group.width_root = group.width_tip = width;
  return ribbons_of(make_strips(std::span(&group, 1)), camera());
}

TEST(Ribbons, CoverEachPixelOnceAlongACurve) {
  const std::vector<Ribbon> ribbons = arc(0.03);
  ASSERT_EQ(ribbons.size(), std::size_t{curve_segments});
  int covered = 0;
  for (int y = 0; y < 256; ++y) {
    for (int x = 0; x < 256; ++x) {
      int times = 0;
      for (const Ribbon& ribbon : ribbons)
        times +=
            on_ribbon(ribbon, {static_cast<float>(x) + 0.5f, static_cast<float>(y) + 0.5f}).opacity > 0.99f ? 1 : 0;
      ASSERT_LE(times, 1) << x << ", " << y;
      covered += times;
    }
  }
  // The arc is .963 long and a pixel .00469: 205 pixels, 5.4 of the ribbon's 6.4 across at full opacity.
  EXPECT_NEAR(covered, 1108, 40);
}

TEST(Ribbons, ThinnerThanAPixelLetMoreThrough) {
  const std::vector<Ribbon> thin = arc(0.0005);
  for (const Ribbon& ribbon : thin) {
    EXPECT_FLOAT_EQ(ribbon.root.reach, 0.5f);
    EXPECT_NEAR(ribbon.root.strength, 0.0005 / (0.6 / 256 * 2), 0.02);
  }
}

TEST(Ribbons, AreNotThereBehindTheCamera) {
  RibbonCamera behind = camera();
  FurFrame frame;
  frame.camera = {.position = {0, 0, -1}, .tan_half_fov = 0.3f};
  frame.width = frame.height = 256;
  behind.to_clip = world_to_clip(frame), behind.viewpoint = frame.camera.position;
  FurCurves group;
  group.guides = {{.points = {{0, 0, 0}, {0, 0.1, 0}}}}, group.width_root = 0.01;
  EXPECT_TRUE(ribbons_of(make_strips(std::span(&group, 1)), behind).empty());
}

}  // namespace
}  // namespace pelage
