// Rotations of a surface that moves.
#include "server/surface/turns.h"

#include <gtest/gtest.h>

#include <glm/gtc/matrix_transform.hpp>

#include "server/builtin/builtin.h"
#include "server/surface/prepare.h"

namespace pelage::turns_test {
namespace {

Mesh mesh_of(Builtin shape) { return std::move(prepare(make_builtin({shape, 1000}))).value(); }

template <typename Move>
std::vector<glm::vec3> moved_by(const Mesh& mesh, const Move& move) {
  std::vector<glm::vec3> positions;
  for (const glm::vec3& p : mesh.positions) positions.emplace_back(move(glm::dvec3(p)));
  return positions;
}

double off(const glm::dmat3& a, const glm::dmat3& b) {
  double largest = 0;
  for (int k = 0; k < 3; ++k) largest = std::max(largest, glm::length(a[k] - b[k]));
  return largest;
}

void expect_rotations(const std::vector<glm::dmat3>& turns) {
  for (const glm::dmat3& turn : turns) {
    ASSERT_LT(off(turn * glm::transpose(turn), glm::dmat3(1)), 1e-9);
    ASSERT_NEAR(glm::determinant(turn), 1, 1e-9);
  }
}

TEST(Turns, OfAThingThatIsTurnedAreItsRotation) {
  const glm::dmat3 turn(glm::rotate(glm::dmat4(1), 2.5, glm::normalize(glm::dvec3(1, 2, -1))));
  for (const Builtin shape : {Builtin::creature, Builtin::torus, Builtin::plane}) {
    const Mesh mesh = mesh_of(shape);
    for (const glm::dmat3& found :
         surface_rotations(mesh, moved_by(mesh, [&](glm::dvec3 p) { return turn * p * 1.5 + glm::dvec3(3, 2, 1); })))
      ASSERT_LT(off(found, turn), 2e-4);
  }
}

TEST(Turns, OfASheetThatShearsAreItsPolarFactor) {
  const Mesh mesh = mesh_of(Builtin::plane);
  const double shear = 0.4, angle = std::atan(shear / 2);  // rotation by the polar factor of ((1, shear), (0, 1))
  const glm::dvec3 up(mesh.normals[0]);
  const glm::dvec3 x = tailward(up), y = glm::cross(up, x);
  const auto turns =
      surface_rotations(mesh, moved_by(mesh, [&](glm::dvec3 p) { return p + shear * glm::dot(p, y) * x; }));
  for (const glm::dmat3& turn : turns)
    ASSERT_LT(glm::distance(turn * x, std::cos(angle) * x - std::sin(angle) * y), 1e-4);
}

TEST(Turns, AreRotationsWhateverHappens) {
  const Mesh mesh = mesh_of(Builtin::creature);
  expect_rotations(surface_rotations(mesh, moved_by(mesh, [](glm::dvec3) { return glm::dvec3(0); })));
  expect_rotations(surface_rotations(mesh, moved_by(mesh, [](glm::dvec3 p) { return -p; })));
  expect_rotations(surface_rotations(mesh, moved_by(mesh, [](glm::dvec3 p) { return 1e3 * p; })));
  expect_rotations(surface_rotations(mesh, moved_by(mesh, [](glm::dvec3 p) { return 1e-12 * p; })));
  expect_rotations(surface_rotations(mesh, moved_by(mesh, [](glm::dvec3 p) {
                                       return glm::dvec3(p.x * std::sin(40 * p.y), p.z, std::cos(90 * p.x));
                                     })));
}

TEST(Turns, TakeNormalsAndTangentsAlong) {
  const Mesh rest = mesh_of(Builtin::creature);
  const glm::dmat3 turn(glm::rotate(glm::dmat4(1), 1.1, glm::normalize(glm::dvec3(0, 1, 1))));
  std::vector<glm::vec3> there = moved_by(rest, [&](glm::dvec3 p) { return turn * p; });
  const std::vector<glm::dmat3> turns = surface_rotations(rest, there);
  const Mesh mesh = moved(rest, there, turns);
  EXPECT_EQ(mesh.positions, there);
  EXPECT_EQ(mesh.triangles, rest.triangles);
  EXPECT_EQ(mesh.size, rest.size);
  for (std::size_t v = 0; v < there.size(); ++v) {
    ASSERT_LT(glm::distance(turn * glm::dvec3(rest.normals[v]), glm::dvec3(mesh.normals[v])), 2e-4);
    ASSERT_LT(glm::distance(turn * glm::dvec3(rest.tangents[v]), glm::dvec3(mesh.tangents[v])), 2e-4);
  }
  ASSERT_EQ(mesh.shading_normals.size(), rest.shading_normals.size());
  for (std::size_t t = 0; t < rest.shading_normals.size(); ++t)
    ASSERT_LT(glm::distance(turn * glm::dvec3(rest.shading_normals[t][1]), glm::dvec3(mesh.shading_normals[t][1])),
              2e-4);
}

}  // namespace
}  // namespace pelage::turns_test
