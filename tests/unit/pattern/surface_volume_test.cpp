// Volumes around a surface that has moved hold the values of its rest pose.
#include "renderer/pattern/surface_volume.h"

#include <gtest/gtest.h>

#include <cmath>
#include <glm/gtc/matrix_transform.hpp>

namespace pelage {
namespace {

constexpr std::array<glm::vec3, 3> triangle{glm::vec3(0.1f, 0, 0), {0.3f, 0.05f, 0.02f}, {0.15f, 0.2f, 0}};
const glm::mat3 quarter(glm::rotate(glm::dmat4(1), 0.7, glm::normalize(glm::dvec3(1, -2, 0.5))));

TEST(TurnOfTriangle, IsTheRotationThatMovedIt) {
  const auto turned = [](glm::vec3 p) { return quarter * p + glm::vec3(1, 2, 3); };
  const glm::mat3 rotation =
      rotation_of_triangle(triangle, {turned(triangle[0]), turned(triangle[1]), turned(triangle[2])});
  for (int k = 0; k < 3; ++k) EXPECT_LT(glm::distance(rotation[k], quarter[k]), 1e-5f);
  EXPECT_EQ(rotation_of_triangle(triangle, {triangle[0], triangle[0], triangle[0]}), glm::mat3(1));
  EXPECT_EQ(rotation_of_triangle({glm::vec3(0), glm::vec3(0), glm::vec3(0)}, triangle), glm::mat3(1));
}

/// The value of the volume's cell that contains a point.
glm::vec4 value_at(const SurfaceVolume& volume, glm::vec3 position) {
  const glm::ivec3 at((position - volume.origin) / volume.cell);
  const auto cell = static_cast<std::size_t>((at.z * volume.size.y + at.y) * volume.size.x + at.x);
  return glm::vec4(volume.rgba[4 * cell], volume.rgba[4 * cell + 1], volume.rgba[4 * cell + 2],
                   volume.rgba[4 * cell + 3]) /
         255.0f;
}

TEST(SurfaceVolumes, OfAMovedSurfaceUseItsRestPose) {
  std::vector<glm::vec3> now, normals, rest(triangle.begin(), triangle.end());
  const glm::vec3 normal = glm::normalize(glm::cross(rest[1] - rest[0], rest[2] - rest[0]));
  const std::vector<glm::vec3> rest_normals(3, normal);
  for (const glm::vec3& p : rest) now.push_back(quarter * p - glm::vec3(0.2f)), normals.push_back(quarter * normal);
  const std::vector<glm::uvec3> triangles{{0, 1, 2}};
  const auto value = [&](const RestPosePoint& middle) {
    EXPECT_LT(glm::distance(middle.normal, normal), 1e-5f);
    EXPECT_LT(glm::distance(middle.rotation * glm::vec3(1, 0, 0), quarter[0]), 1e-5f);
    return glm::vec4(middle.position, 1);
  };
  const SurfaceVolume volume = make_surface_volume({now, normals, triangles, rest, rest_normals}, value);
  for (const glm::vec3 share : {glm::vec3(0.2f, 0.5f, 0.3f), {0.6f, 0.2f, 0.2f}, {1.0f / 3, 1.0f / 3, 1.0f / 3}}) {
    const glm::vec3 position = share.x * now[0] + share.y * now[1] + share.z * now[2];
    const glm::vec3 expected = share.x * rest[0] + share.y * rest[1] + share.z * rest[2];
    const glm::vec4 found = value_at(volume, position);
    EXPECT_LT(glm::distance(glm::vec3(found), glm::clamp(expected, 0.0f, 1.0f)), 1.8f * volume.cell + 0.004f);
    EXPECT_EQ(found.a, 1);
  }
}

}  // namespace
}  // namespace pelage
