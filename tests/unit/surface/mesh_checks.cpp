#include "tests/unit/surface/mesh_checks.h"

#include <cmath>

#include "server/patches/patches.h"

namespace pelage {

namespace {

bool is_finite(glm::vec3 v) { return std::isfinite(v.x) && std::isfinite(v.y) && std::isfinite(v.z); }

/// Expects patches that cover every triangle with weights that sum to 1, at finite positions.
void expect_patches(const Mesh& mesh) {
  const PatchMap map = lay_patches(mesh);
  std::vector<glm::dvec3> sums(mesh.triangles.size(), glm::dvec3(0));
  std::size_t bad_points = 0, bad_sums = 0;
  for (const PatchPoint& point : map.points) {
    const bool good =
        std::isfinite(point.uv.x) && std::isfinite(point.uv.y) && std::abs(glm::length(point.axis) - 1) < 1e-4f;
    if (!good) ++bad_points;
  }
  for (const PatchTriangle& patch_triangle : map.patch_triangles) {
    for (int k = 0; k < 3; ++k) sums[patch_triangle.triangle][k] += double{map.points[patch_triangle.points[k]].weight};
  }
  for (const glm::dvec3& sum : sums) {
    for (int k = 0; k < 3; ++k) bad_sums += !(std::abs(sum[k] - 1) < 1e-5);
  }
  EXPECT_EQ(bad_points, 0u);
  EXPECT_EQ(bad_sums, 0u);
}

}  // namespace

void expect_groomable(const Mesh& mesh) {
  const std::size_t count = mesh.positions.size();
  ASSERT_GT(mesh.triangles.size(), 0u);
  ASSERT_EQ(mesh.normals.size(), count);
  ASSERT_EQ(mesh.tangents.size(), count);
  ASSERT_EQ(mesh.length_scale.size(), count);
  ASSERT_TRUE(mesh.corners.empty() || mesh.corners.size() == mesh.triangles.size());
  ASSERT_TRUE(mesh.texture_uv.empty() || mesh.texture_uv.size() == mesh.triangles.size());
  EXPECT_EQ(mesh.report.vertices, count);
  EXPECT_EQ(mesh.report.triangles, mesh.triangles.size());
  EXPECT_GT(mesh.size, 0);
  std::size_t bad_frames = 0, bad_triangles = 0, unused = count;
  glm::vec3 low(1), high(-1);
  for (std::size_t v = 0; v < count; ++v) {
    const glm::vec3 n = mesh.normals[v], t = mesh.tangents[v];
    const bool good = is_finite(mesh.positions[v]) && std::abs(glm::length(n) - 1) < 1e-5f &&
                      std::abs(glm::length(t) - 1) < 1e-5f && std::abs(glm::dot(n, t)) < 1e-5f;
    if (!good) ++bad_frames;
    low = glm::min(low, mesh.positions[v]);
    high = glm::max(high, mesh.positions[v]);
  }
  EXPECT_NEAR(glm::length(high - low), 1, 1e-5);
  EXPECT_NEAR(glm::length(high + low), 0, 1e-5);
  std::vector<bool> used(count, false);
  for (const glm::uvec3& t : mesh.triangles) {
    if (t.x == t.y || t.y == t.z || t.z == t.x || std::max({t.x, t.y, t.z}) >= count) {
      ++bad_triangles;
      continue;
    }
    for (int k = 0; k < 3; ++k) {
      if (!used[t[k]]) --unused;
      used[t[k]] = true;
    }
  }
  EXPECT_EQ(bad_frames, 0u);
  EXPECT_EQ(bad_triangles, 0u);
  EXPECT_EQ(unused, 0u);
  expect_patches(mesh);
}

}  // namespace pelage
