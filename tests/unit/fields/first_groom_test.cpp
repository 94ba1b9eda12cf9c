#include "server/first_groom/first_groom.h"

#include <gtest/gtest.h>

#include <cmath>

#include "server/builtin/builtin.h"
#include "server/fields/field_set.h"
#include "server/surface/prepare.h"

namespace pelage {
namespace {

TEST(FirstGroom, LeansFromNoseToTailWithTheAskedInclinationAndLength) {
  Result<Mesh> mesh = prepare(make_builtin({Builtin::torus, 3000}));
  ASSERT_TRUE(mesh.ok());
  mesh->length_scale.resize(mesh->positions.size());
  for (std::size_t v = 0; v < mesh->length_scale.size(); ++v) mesh->length_scale[v] = v % 2 == 0 ? 0.5f : 2.0f;
  const FieldSet fields = first_groom(*mesh, {.length = 0.04, .inclination = 0.6});
  std::size_t tailwards = 0, judged = 0;
  for (std::uint32_t v = 0; v < fields.size(); ++v) {
    const glm::vec3 bitangent = glm::cross(mesh->normals[v], mesh->tangents[v]);
    const glm::vec3 lean = fields.direction()[v].x * mesh->tangents[v] + fields.direction()[v].y * bitangent;
    EXPECT_NEAR(fields.length()[v], v % 2 == 0 ? 0.02 : 0.08, 1e-6);
    EXPECT_EQ(fields.at(v).stretch, 0);
    if (std::abs(mesh->normals[v].z) > 0.5f) continue;
    ++judged;
    EXPECT_NEAR(glm::length(lean), 0.6, 1e-5);
    tailwards += lean.z < -0.2f;
  }
  EXPECT_GT(judged, 500u);
  EXPECT_GT(tailwards, judged * 95 / 100);
}

// Nose and rump point along the way that fur lies: there it stands up, so that no whorl shows.
TEST(FirstGroom, StandsUpWhereNoWayLeadsToTheTail) {
  const Result<Mesh> mesh = prepare(make_builtin({Builtin::sphere, 8000}));
  ASSERT_TRUE(mesh.ok());
  const FieldSet fields = first_groom(*mesh, {.inclination = 0.6});
  const glm::vec3 way = glm::normalize(glm::vec3(0, -0.35f, -1));
  for (std::uint32_t v = 0; v < fields.size(); ++v) {
    const float across = glm::length(mesh->normals[v] - glm::dot(mesh->normals[v], way) * way);
    EXPECT_LE(glm::length(fields.direction()[v]), 0.6f + 1e-5f);
    if (across < 0.05f) {
      EXPECT_LT(glm::length(fields.direction()[v]), 0.05f);
    }
  }
}

TEST(FirstGroom, AnimalsHaveShortFacesAndPawsAndLongChestsAndTails) {
  const Result<Mesh> mesh = prepare(make_builtin({Builtin::creature, 8000}));
  ASSERT_TRUE(mesh.ok());
  Mesh bare = *mesh;
  bare.length_scale.clear();
  const FieldSet even = first_groom(bare, {.length = 0.03}),
                 animal = first_groom(bare, {.length = 0.03, .form = GroomForm::animal});
  glm::vec3 low(1), high(-1);
  for (const glm::vec3& p : bare.positions) low = glm::min(low, p), high = glm::max(high, p);
  for (std::uint32_t v = 0; v < even.size(); ++v) {
    const glm::vec3 share = (bare.positions[v] - low) / (high - low);
    EXPECT_NEAR(even.length()[v], 0.03f, 1e-6);
    EXPECT_GE(animal.length()[v], 0.03f * 0.4f * 0.5f);
    EXPECT_LE(animal.length()[v], 0.03f * 1.4f * 1.3f);
    if (share.z > 0.9f && share.y > 0.65f) {
      EXPECT_LT(animal.length()[v], 0.016f);
    }
    if (share.y < 0.04f) {
      EXPECT_LT(animal.length()[v], 0.021f);
    }
    if (share.z < 0.04f && share.y > 0.3f) {
      EXPECT_GT(animal.length()[v], 0.037f);
    }
  }
}

}  // namespace
}  // namespace pelage
