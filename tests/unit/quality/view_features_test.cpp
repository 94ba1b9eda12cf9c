// What is told of a view without drawing it, against what can be counted by hand.
#include "renderer/quality/view_features.h"

#include <gtest/gtest.h>

#include <cmath>

#include "tests/unit/quality/views.h"

namespace pelage {
namespace {

using testing::frame_of;
using testing::Patch;

TEST(ViewFeatures, ASquareCoversWhatItProjectsTo) {
  const Patch patch(8, 0.25f, 0.0f);
  const ViewFeatures view = view_features(frame_of(400, 400), patch.skin());
  EXPECT_NEAR(view.area, 200 * 200, 1);  // half of the height, squared
  EXPECT_NEAR(view.covered, 200 * 200, 0.15 * 200 * 200);
  EXPECT_EQ(view.triangles, 128);
  EXPECT_EQ(view.visible, 128);
  EXPECT_NEAR(view.edges, 128 * 25 * (2 + std::sqrt(2.0)), 1);
  EXPECT_EQ(view.behind, 0);
  EXPECT_NEAR(view.bending, 0, 1e-12);
  EXPECT_EQ(view.lights, 3);
}

TEST(ViewFeatures, PlacesAreSpreadOverTheFur) {
  const Patch patch(8, 0.25f, 0.0f);
  const std::vector<glm::vec2> places = view_features(frame_of(400, 400), patch.skin()).places;
  ASSERT_EQ(places.size(), 6u);
  glm::vec2 low(400), high(0);
  for (const glm::vec2& place : places) low = glm::min(low, place), high = glm::max(high, place);
  EXPECT_GT(std::min(low.x, low.y), 90);  // the square is 200 pixels wide
  EXPECT_LT(std::max(high.x, high.y), 310);
  EXPECT_GT(std::min(high.x - low.x, high.y - low.y), 90);
}

TEST(Windows, ShowAPlaceOfThePictureWithItsPixels) {
  const FurFrame frame = frame_of(400, 300);
  const FurFrame middle = window_of(frame, {200, 150}, 60);
  EXPECT_EQ(middle.camera.forward, frame.camera.forward);
  EXPECT_FLOAT_EQ(middle.camera.tan_half_fov / frame.camera.tan_half_fov, 60.0f / 300);
  const FurFrame corner = window_of(frame, {360, 30}, 60);
  const auto pixel_of = [&](const FurFrame& seen, const glm::vec3& at) {
    const glm::vec3 off = at - seen.camera.position;
    const float focal =
        static_cast<float>(seen.height) / (2 * seen.camera.tan_half_fov) / glm::dot(off, seen.camera.forward);
    return glm::vec2(seen.width, seen.height) * 0.5f +
           focal * glm::vec2(glm::dot(off, seen.camera.right), -glm::dot(off, seen.camera.up));
  };
  const FurCamera& camera = frame.camera;
  const float half = camera.tan_half_fov / 150;  // a pixel at distance 1
  for (const glm::vec2 off : {glm::vec2(0), glm::vec2(20, 0), glm::vec2(0, 20), glm::vec2(-15, 10)}) {
    const glm::vec2 pixel = glm::vec2(360, 30) + off - glm::vec2(200, 150);
    const glm::vec3 at = camera.position + camera.forward + half * (pixel.x * camera.right - pixel.y * camera.up);
    EXPECT_LT(glm::distance(pixel_of(corner, at) - glm::vec2(30), off), 0.2f * glm::length(off) + 1e-3f);
  }
}

TEST(ViewFeatures, LengthsAreInPixels) {
  const Patch patch(8, 0.25f, 0.02f);
  FurFrame frame = frame_of(400, 400);
  frame.coat.width_root = 0.001;
  const ViewFeatures near = view_features(frame, patch.skin());
  EXPECT_NEAR(near.fur_pixels, 8, 0.2);
  EXPECT_NEAR(near.strand_pixels, 0.4, 0.01);
  frame.camera.position.z = 2;
  const ViewFeatures far = view_features(frame, patch.skin());
  EXPECT_NEAR(far.fur_pixels / near.fur_pixels, 0.5, 0.01);
  EXPECT_NEAR(far.area / near.area, 0.25, 0.01);
}

TEST(ViewFeatures, WhatIsTurnedAwayOrOutsideIsNotSeen) {
  const Patch patch;
  FurFrame behind = frame_of(64, 64);
  behind.camera.position = {0, 0, -1}, behind.camera.forward = {0, 0, 1};
  EXPECT_EQ(view_features(behind, patch.skin()).visible, 0);
  FurFrame past = frame_of(64, 64);
  past.camera.position = {5, 0, 1};
  EXPECT_EQ(view_features(past, patch.skin()).area, 0);
}

TEST(ViewFeatures, FurBehindOtherFurIsToldApart) {
  Patch front(8, 0.25f), back(8, 0.25f);
  const auto first = static_cast<std::uint32_t>(front.positions.size());
  for (const glm::vec3& p : back.positions) front.positions.push_back(p - glm::vec3(0, 0, 0.5f));
  front.normals.insert(front.normals.end(), back.normals.begin(), back.normals.end());
  front.length.insert(front.length.end(), back.length.begin(), back.length.end());
  for (const glm::uvec3& t : back.triangles) front.triangles.push_back(t + first);
  const ViewFeatures view = view_features(frame_of(256, 256), front.skin());
  EXPECT_NEAR(view.behind, 0.31, 0.05);  // (1 / 1.5)^2 over 1 + (1 / 1.5)^2
}

TEST(ViewFeatures, PiecesCountAsTriangles) {
  const Patch patch;
  FurredSkin skin = patch.skin();
  skin.pieces = 1.5;
  const ViewFeatures view = view_features(frame_of(256, 256), skin),
                     plain = view_features(frame_of(256, 256), patch.skin());
  EXPECT_NEAR(view.area / plain.area, 1.5, 1e-9);
  EXPECT_NEAR(view.triangles / plain.triangles, 1.5, 1e-9);
}

TEST(ViewFeatures, ManyTrianglesAreLookedAtInPart) {
  const Patch coarse(16), fine(256);
  const ViewFeatures a = view_features(frame_of(256, 256), coarse.skin()),
                     b = view_features(frame_of(256, 256), fine.skin());
  EXPECT_EQ(b.triangles, 2.0 * 256 * 256);
  EXPECT_NEAR(b.area / a.area, 1, 0.02);
}

TEST(ViewFeatures, ExtremesAreFinite) {
  const Patch patch, bald(8, 0.25f, 0.0f), long_fur(8, 0.25f, 10.0f);
  for (const Patch* skin : {&patch, &bald, &long_fur}) {
    for (const auto& [width, height] : {std::pair{1, 1}, {8192, 8192}, {8192, 1}}) {
      for (const float distance : {0.0f, 1e-9f, 0.01f, 1e20f}) {
        const ViewFeatures view = view_features(frame_of(width, height, distance), skin->skin());
        for (const double value : {view.area, view.edges, view.covered, view.behind, view.fur_pixels,
                                   view.strand_pixels, view.bending, view.visible}) {
          EXPECT_TRUE(std::isfinite(value) && value >= 0) << width << " x " << height << " from " << distance;
        }
      }
    }
  }
  EXPECT_EQ(view_features(frame_of(64, 64), FurredSkin{}).area, 0);
}

}  // namespace
}  // namespace pelage
