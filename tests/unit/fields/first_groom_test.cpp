#include <gtest/gtest.h>

#include <cmath>

#include "server/fields/field_set.h"
#include "server/surface/builtin.h"
#include "server/surface/prepare.h"

namespace pelage {
namespace {

TEST(FirstGroom, LeansFromNoseToTailWithTheAskedInclinationAndLength) {
  Result<Mesh> mesh = prepare(make_builtin({Builtin::torus, 3000}), Axis::plus_y, Axis::plus_z, false);
  ASSERT_TRUE(mesh.ok());
  mesh->length_scale.resize(mesh->positions.size());
  for (std::size_t v = 0; v < mesh->length_scale.size(); ++v) mesh->length_scale[v] = v % 2 == 0 ? 0.5f : 2.0f;
  const FieldSet fields = first_groom(*mesh, {.length = 0.04, .inclination = 0.6});
  std::size_t tailwards = 0, judged = 0;
  for (std::uint32_t v = 0; v < fields.size(); ++v) {
    const glm::vec3 bitangent = glm::cross(mesh->normals[v], mesh->tangents[v]);
    const glm::vec3 lean = fields.direction()[v].x * mesh->tangents[v] + fields.direction()[v].y * bitangent;
    EXPECT_NEAR(glm::length(lean), 0.6, 1e-5);
    EXPECT_NEAR(fields.length()[v], v % 2 == 0 ? 0.02 : 0.08, 1e-6);
    EXPECT_EQ(fields.at(v).stretch, 0);
    if (std::abs(mesh->normals[v].z) > 0.5f) continue;
    ++judged;
    tailwards += lean.z < -0.2f;
  }
  EXPECT_GT(judged, 500u);
  EXPECT_GT(tailwards, judged * 95 / 100);
}

}  // namespace
}  // namespace pelage
