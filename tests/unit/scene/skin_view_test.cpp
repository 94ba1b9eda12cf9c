#include <gtest/gtest.h>

#include "server/frames/fur_view.h"

namespace pelage::skin_view_test {
namespace {

Mesh mesh_of_size(double size, glm::dvec3 centre) {
  Mesh mesh;
  mesh.size = size, mesh.centre = centre;
  return mesh;
}

FurSkinRegion made(const SkinRegion& region) { return make_skin({region}, mesh_of_size(4, {1, 2, 3})).at(0); }

void expect_near(glm::dvec3 a, glm::dvec3 b) {
  EXPECT_LT(glm::distance(a, b), 1e-12) << a.x << " " << a.y << " " << a.z;
}

TEST(SkinView, PlacesRegionsInSizes) {
  const FurSkinRegion region = made({.centre = {3, 2, 3}, .radii = {0.1, 0.2, 0.5}});
  expect_near(region.centre, {0.5, 0, 0});
  expect_near(region.to_unit * glm::dvec3(0.1, 0, 0), {1, 0, 0});
  expect_near(region.to_unit * glm::dvec3(0, 0.2, 0), {0, 1, 0});
  expect_near(region.to_unit * glm::dvec3(0, 0, 0.5), {0, 0, 1});
}

TEST(SkinView, TurnsRegionsToTheirAxis) {
  FurSkinRegion region = made({.radii = {0.1, 0.2, 0.5}, .axis = {2, 0, 0}});
  expect_near(region.to_unit * glm::dvec3(0.5, 0, 0), {0, 0, 1});
  expect_near(region.to_unit * glm::dvec3(0, 0.2, 0), {0, 1, 0});
  region = made({.radii = {0.1, 0.2, 0.5}, .turn_degrees = 90});
  expect_near(region.to_unit * glm::dvec3(0, 0.1, 0), {1, 0, 0});
  region = made({.radii = {0.1, 0.2, 0.5}, .axis = {0, 1, 0}});
  EXPECT_NEAR(glm::length(region.to_unit * glm::dvec3(0, 0.5, 0)), 1, 1e-12);
}

TEST(SkinView, FacingIsACone) {
  SkinRegion region{.facing = SkinFacing{.direction = {0, 3, 0}, .angle_degrees = 60, .fade_degrees = 30}};
  EXPECT_NEAR(made(region).cosine_full, 0.5, 2e-6);
  EXPECT_NEAR(made(region).cosine_none, 0, 1e-12);
  expect_near(made(region).facing, {0, 1, 0});
  region.facing->angle_degrees = 180;
  EXPECT_LT(made(region).cosine_full, -1);  // accepts a rounded normal too
  region.facing.reset();
  EXPECT_LT(made(region).cosine_full, -1);
}

}  // namespace
}  // namespace pelage::skin_view_test
