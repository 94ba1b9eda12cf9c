// Shading normals, and the direction in which fur grows at edges.
#include "server/surface/shading_normals.h"

#include <gtest/gtest.h>

#include "tests/unit/surface/shapes.h"

namespace pelage::shading_normals_test {
namespace {

glm::vec3 face_normal(const Mesh& mesh, std::size_t t) {
  const glm::uvec3 v = mesh.triangles[t];
  return glm::normalize(
      glm::cross(mesh.positions[v.y] - mesh.positions[v.x], mesh.positions[v.z] - mesh.positions[v.x]));
}

TEST(ShadingNormals, OfACubeAreThoseOfItsSides) {
  const Mesh mesh = shapes::prepared(shapes::cube()).value();
  ASSERT_EQ(mesh.shading_normals.size(), mesh.triangles.size());
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
    for (const glm::vec3& normal : mesh.shading_normals[t])
      EXPECT_LT(glm::distance(normal, face_normal(mesh, t)), 1e-6f);
  }
}

TEST(ShadingNormals, SmoothShapesHaveNone) {
  EXPECT_TRUE(shapes::prepared(shapes::ball(12)).value().shading_normals.empty());
  EXPECT_TRUE(prepare(shapes::cube(), {.crease_degrees = 100}).value().shading_normals.empty());
}

// Vertices without a crease keep their bits, so models without creases are drawn as before.
TEST(ShadingNormals, ChangeAtCreasesAlone) {
  RawModel half = shapes::ball(16);  // cut in half, which gives it a flat lid
  const RawModel ball = half;
  for (glm::dvec3& p : half.positions) p.y = std::max(p.y, 0.0);
  const Mesh cut = shapes::prepared(half).value();
  ASSERT_FALSE(cut.shading_normals.empty());
  std::size_t unchanged = 0;
  for (std::size_t t = 0; t < cut.triangles.size(); ++t) {
    for (int k = 0; k < 3; ++k)
      unchanged += cut.shading_normals[t][static_cast<std::size_t>(k)] == cut.normals[cut.triangles[t][k]] ? 1 : 0;
  }
  EXPECT_GT(unchanged, cut.triangles.size());
}

// With area weights only the large sides would count, and fur on the rim would grow along them.
TEST(ShadingNormals, FurGrowsOutOfTheRimOfAThinSheet) {
  RawModel raw = shapes::cube();
  for (glm::dvec3& p : raw.positions) p.z *= 0.01;
  const Mesh mesh = shapes::prepared(raw).value();
  for (std::size_t v = 0; v < mesh.normals.size(); ++v) {
    EXPECT_GT(std::abs(mesh.normals[v].x), 0.5f);
    EXPECT_GT(std::abs(mesh.normals[v].z), 0.5f);
    EXPECT_NEAR(glm::dot(mesh.normals[v], mesh.tangents[v]), 0, 1e-6);
  }
}

// Otherwise the roots of a cloth's fur are seen from the side, and look dark.
TEST(ShadingNormals, FurLeansOverOpenRims) {
  RawModel raw = shapes::cube();
  raw.face_sizes.pop_back(), raw.corners.resize(raw.corners.size() - 4);  // removes the side that faces along X
  Mesh mesh = shapes::prepared(raw).value();
  lean_over_rims(mesh);
  for (std::size_t v = 0; v < mesh.normals.size(); ++v) {
    EXPECT_EQ(mesh.normals[v].x > 0.3f, mesh.positions[v].x > 0) << v;
    EXPECT_NEAR(glm::dot(mesh.normals[v], mesh.tangents[v]), 0, 1e-6);
  }
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {  // shading normals of the skin stay
    for (const glm::vec3& normal : mesh.shading_normals[t])
      EXPECT_LT(glm::distance(normal, face_normal(mesh, t)), 1e-6f);
  }
}

}  // namespace
}  // namespace pelage::shading_normals_test
