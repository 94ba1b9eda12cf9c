// Which way parts are wound, and what hardly belongs to a model.
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
  const DoubtfulPart& part = inside_out.report.doubtful_parts.front();
  EXPECT_EQ(part.part, 1);
  EXPECT_EQ(part.triangles, 10u);
  EXPECT_LT(glm::distance(part.centre, glm::dvec3(6, 1, 1)), 1e-6);
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
