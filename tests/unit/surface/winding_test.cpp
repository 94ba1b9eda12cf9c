// Winding of parts, and what probably does not belong to a model.
#include <gtest/gtest.h>

#include <algorithm>

#include "tests/unit/surface/shapes.h"

namespace pelage::winding_test {
namespace {

std::size_t count_of(const Mesh& mesh, const char* code) {
  for (const Repair& repair : mesh.report.repairs)
    if (repair.code == code) return repair.count;
  return 0;
}

RawModel turned(RawModel raw) {
  std::size_t begin = 0;
  for (const std::uint32_t size : raw.face_sizes) {
    const auto first = raw.corners.begin() + static_cast<std::ptrdiff_t>(begin);
    std::reverse(first, first + size);
    begin += size;
  }
  return raw;
}

RawModel without_lid(RawModel cube) {
  cube.face_sizes.pop_back();
  cube.corners.resize(cube.corners.size() - 4);
  return cube;
}

TEST(Winding, ClosedPartsFaceOutwards) {
  const Mesh mesh = shapes::prepared(turned(shapes::cube())).value();
  EXPECT_EQ(count_of(mesh, "flipped_triangles"), 12u);
  EXPECT_TRUE(mesh.report.doubtful_parts.empty());
}

TEST(Winding, OpenPartsKeepTheirsAndAreReported) {
  const Mesh good = shapes::prepared(without_lid(shapes::cube())).value();
  EXPECT_EQ(count_of(good, "flipped_triangles"), 0u);
  EXPECT_TRUE(good.report.doubtful_parts.empty());
  const Mesh inside_out = shapes::prepared(turned(without_lid(shapes::cube(2, {5, 0, 0})))).value();
  EXPECT_EQ(count_of(inside_out, "flipped_triangles"), 0u);
  ASSERT_EQ(inside_out.report.doubtful_parts.size(), 1u);
  const NumberedPart& part = inside_out.report.doubtful_parts.front();
  EXPECT_EQ(part.part, 1);
  EXPECT_EQ(part.triangles, 10u);
  EXPECT_LT(glm::distance(part.centre, glm::dvec3(6, 1, 1)), 1e-6);
}

/// The model without every n-th face.
RawModel with_holes(const RawModel& raw, std::size_t n) {
  RawModel holed;
  holed.positions = raw.positions;
  for (std::size_t f = 0; f < raw.face_sizes.size(); ++f) {
    if (f % n == n / 2) continue;
    holed.face_sizes.push_back(3);
    for (std::size_t k = 0; k < 3; ++k) holed.corners.push_back(raw.corners[3 * f + k]);
  }
  return holed;
}

// Scans have such holes.
TEST(Winding, PartsThatAreNearlyClosedFaceOutwards) {
  const RawModel scan = with_holes(shapes::ball(24), 500);
  const Mesh inside_out = shapes::prepared(turned(scan)).value();
  EXPECT_GT(count_of(inside_out, "open_edges"), 9u);
  EXPECT_EQ(count_of(inside_out, "flipped_triangles"), inside_out.triangles.size());
  EXPECT_TRUE(inside_out.report.doubtful_parts.empty());
  EXPECT_EQ(count_of(shapes::prepared(scan).value(), "flipped_triangles"), 0u);
}

/// A ball, and beside it a sheet of eight triangles in the xy plane that faces along z.
RawModel ball_and_sheet() {
  RawModel raw = shapes::ball(8);
  const auto first = static_cast<std::uint32_t>(raw.positions.size());
  for (int y = 0; y < 3; ++y)
    for (int x = 0; x < 3; ++x) raw.positions.emplace_back(3 + x, y, 0);
  for (std::uint32_t y = 0; y < 2; ++y) {
    for (std::uint32_t x = 0; x < 2; ++x) {
      const std::uint32_t corner = first + 3 * y + x;
      raw.face_sizes.push_back(4);
      for (const std::uint32_t v : {corner, corner + 1, corner + 4, corner + 3}) raw.corners.push_back(v);
      if (!raw.face_material.empty()) raw.face_material.push_back(0);
    }
  }
  return raw;
}

TEST(Winding, SheetsAreReportedAndGetABack) {
  const RawModel raw = ball_and_sheet();
  const Mesh plain = prepare(raw).value();
  ASSERT_EQ(plain.report.sheets.size(), 1u);
  EXPECT_EQ(plain.report.sheets.front().part, 2);
  EXPECT_EQ(plain.report.sheets.front().triangles, 8u);
  const Mesh both = prepare(raw, {.two_sided_parts = {2}}).value();
  EXPECT_EQ(both.triangles.size(), plain.triangles.size() + 8);
  ASSERT_EQ(both.positions.size(), plain.positions.size() + 9);
  EXPECT_EQ(both.report.parts, 3u);
  const std::size_t fronts = plain.positions.size();
  for (std::size_t v = 0; v < 9; ++v) {
    EXPECT_NEAR(both.normals[fronts - 9 + v].z, 1, 1e-6);
    EXPECT_NEAR(both.normals[fronts + v].z, -1, 1e-6);
    double nearest = 1;
    for (std::size_t k = fronts - 9; k < fronts; ++k) {
      const glm::dvec3 behind = glm::dvec3(both.positions[k]) - glm::dvec3(0, 0, 1e-3);
      nearest = std::min(nearest, glm::distance(behind, glm::dvec3(both.positions[fronts + v])));
    }
    EXPECT_LT(nearest, 1e-6) << v;
  }
  const auto refused = prepare(raw, {.two_sided_parts = {3}});
  ASSERT_FALSE(refused.ok());
  EXPECT_EQ(refused.status().pointer, "/two_sided");
}

TEST(Winding, OnePartIsFlipped) {
  const RawModel raw = turned(without_lid(shapes::cube()));
  const Mesh mesh = prepare(raw, {.flipped_parts = {1}}).value();
  EXPECT_EQ(count_of(mesh, "flipped_triangles"), 10u);
  const auto refused = prepare(raw, {.flipped_parts = {2}});
  ASSERT_FALSE(refused.ok());
  EXPECT_EQ(refused.status().pointer, "/flip");
  EXPECT_EQ(refused.status().limit, "[1, 1]");
}

TEST(Outliers, FarAndTinyPartsAreCounted) {
  RawModel raw = shapes::ball(12);
  EXPECT_EQ(count_of(shapes::prepared(raw).value(), "far_vertices"), 0u);
  const auto add = [&](double side, glm::dvec3 at) {
    const auto first = static_cast<std::uint32_t>(raw.positions.size());
    const RawModel cube = shapes::cube(side, at);
    raw.positions.insert(raw.positions.end(), cube.positions.begin(), cube.positions.end());
    raw.face_sizes.insert(raw.face_sizes.end(), cube.face_sizes.begin(), cube.face_sizes.end());
    for (const std::uint32_t corner : cube.corners) raw.corners.push_back(first + corner);
  };
  add(0.1, {400, 0, 0}), add(1e-4, {0, 1.2, 0});
  const Mesh mesh = shapes::prepared(raw).value();
  EXPECT_EQ(count_of(mesh, "far_vertices"), 8u);
  EXPECT_EQ(count_of(mesh, "far_parts"), 1u);
  EXPECT_EQ(count_of(mesh, "tiny_parts"), 1u);
}

}  // namespace
}  // namespace pelage::winding_test
