// Features that are estimated without drawing a view, against values counted by hand.
#include "renderer/quality/view_features.h"

#include <gtest/gtest.h>

#include <cmath>

namespace pelage {
namespace {

/// A square of 2 x `cells` x `cells` triangles that faces the camera and extends `half` sizes to each side of the
/// origin.
struct Patch {
  std::vector<glm::vec3> positions, normals;
  std::vector<glm::uvec3> triangles;
  std::vector<float> length;

  explicit Patch(int cells = 8, float half = 0.25f, float fur = 0.03f) {
    for (int j = 0; j <= cells; ++j) {
      for (int i = 0; i <= cells; ++i) {
        const float step = 2 * half / static_cast<float>(cells);
        positions.emplace_back(-half + step * static_cast<float>(i), -half + step * static_cast<float>(j), 0);
        normals.emplace_back(0, 0, 1), length.push_back(fur);
      }
    }
    const auto at = [&](int i, int j) { return static_cast<std::uint32_t>(j * (cells + 1) + i); };
    for (int j = 0; j < cells; ++j) {
      for (int i = 0; i < cells; ++i) {
        triangles.emplace_back(at(i, j), at(i + 1, j), at(i + 1, j + 1));
        triangles.emplace_back(at(i, j), at(i + 1, j + 1), at(i, j + 1));
      }
    }
  }
  FurredSkin skin() const { return {positions, normals, triangles, length, 1}; }
};

/// A camera at `distance` that looks along -z; at distance 1 the picture is one size high.
FurFrame frame_of(int width, int height, float distance = 1) {
  FurFrame frame;
  frame.width = width, frame.height = height;
  frame.camera.position = {0, 0, distance}, frame.camera.tan_half_fov = 0.5f;
  frame.lights.resize(3);
  return frame;
}

TEST(ViewFeatures, ASquareCoversWhatItProjectsTo) {
  const Patch patch(8, 0.25f, 0.0f);
  const ViewFeatures view = view_features(frame_of(400, 400), patch.skin());
  EXPECT_NEAR(view.area, 200 * 200, 1);  // the square is half as wide and high as the picture
  EXPECT_EQ(view.lights, 3);
}

TEST(ViewFeatures, LengthsAreInPixels) {
  const Patch patch(8, 0.25f, 0.02f);
  FurFrame frame = frame_of(400, 400);
  const ViewFeatures near = view_features(frame, patch.skin());
  EXPECT_NEAR(near.fur_pixels, 8, 0.2);
  frame.camera.position.z = 2;
  const ViewFeatures far = view_features(frame, patch.skin());
  EXPECT_NEAR(far.fur_pixels / near.fur_pixels, 0.5, 0.01);
  EXPECT_NEAR(far.area / near.area, 0.25, 0.01);
}

TEST(ViewFeatures, WhatIsTurnedAwayOrOutsideIsNotSeen) {
  const Patch patch;
  FurFrame behind = frame_of(64, 64);
  behind.camera.position = {0, 0, -1}, behind.camera.forward = {0, 0, 1};
  EXPECT_EQ(view_features(behind, patch.skin()).area, 0);
  FurFrame past = frame_of(64, 64);
  past.camera.position = {5, 0, 1};
  EXPECT_EQ(view_features(past, patch.skin()).area, 0);
}

TEST(ViewFeatures, PatchTrianglesLieOverEachOther) {
  const Patch patch;
  FurredSkin skin = patch.skin();
  skin.patch_triangles = 1.5;
  const ViewFeatures view = view_features(frame_of(256, 256), skin),
                     plain = view_features(frame_of(256, 256), patch.skin());
  EXPECT_NEAR(view.area / plain.area, 1.5, 1e-9);
}

TEST(ViewFeatures, ManyTrianglesAreLookedAtInPart) {
  const Patch coarse(16), fine(256);
  const ViewFeatures a = view_features(frame_of(256, 256), coarse.skin()),
                     b = view_features(frame_of(256, 256), fine.skin());
  EXPECT_NEAR(b.area / a.area, 1, 0.02);
}

TEST(ViewFeatures, ExtremesAreFinite) {
  const Patch patch, bald(8, 0.25f, 0.0f), long_fur(8, 0.25f, 10.0f);
  for (const Patch* skin : {&patch, &bald, &long_fur}) {
    for (const auto& [width, height] : {std::pair{1, 1}, {8192, 8192}, {8192, 1}}) {
      for (const float distance : {0.0f, 1e-9f, 0.01f, 1e20f}) {
        const ViewFeatures view = view_features(frame_of(width, height, distance), skin->skin());
        for (const double value : {view.area, view.fur_pixels, view.strands}) {
          EXPECT_TRUE(std::isfinite(value) && value >= 0) << width << " x " << height << " from " << distance;
        }
      }
    }
  }
  EXPECT_EQ(view_features(frame_of(64, 64), FurredSkin{}).area, 0);
}

}  // namespace
}  // namespace pelage
