#include "server/surface/prepare.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "base/limits.h"
#include "server/surface/materials.h"
#include "tests/unit/surface/mesh_checks.h"
#include "tests/unit/surface/shapes.h"

namespace pelage::prepare_test {
namespace {

using shapes::ball;
using shapes::cube;
using shapes::model_of;
using shapes::prepared;

std::size_t count_of(const Mesh& mesh, const std::string& code) {
  for (const Repair& repair : mesh.report.repairs) {
    if (repair.code == code) return repair.count;
  }
  return 0;
}

double signed_volume(const Mesh& mesh) {
  double volume = 0;
  for (const glm::uvec3& t : mesh.triangles) {
    const glm::dvec3 a(mesh.positions[t.x]), b(mesh.positions[t.y]), c(mesh.positions[t.z]);
    volume += glm::dot(a, glm::cross(b, c)) / 6;
  }
  return volume;
}

double area(const Mesh& mesh) {
  double sum = 0;
  for (const glm::uvec3& t : mesh.triangles) {
    const glm::dvec3 a(mesh.positions[t.x]), b(mesh.positions[t.y]), c(mesh.positions[t.z]);
    sum += glm::length(glm::cross(b - a, c - a)) / 2;
  }
  return sum * mesh.size * mesh.size;
}

TEST(Prepare, CubeIsCentredScaledAndOutward) {
  const Result<Mesh> mesh = prepared(cube(3, {1, 2, 3}));
  ASSERT_TRUE(mesh.ok());
  expect_groomable(*mesh);
  EXPECT_EQ(mesh->triangles.size(), 12u);
  EXPECT_DOUBLE_EQ(mesh->size, 3 * std::sqrt(3.0));
  EXPECT_EQ(mesh->centre, glm::dvec3(2.5, 3.5, 4.5));
  EXPECT_EQ(mesh->report.bounds.min, glm::dvec3(1, 2, 3));
  EXPECT_NEAR(signed_volume(*mesh), 1 / std::pow(3, 1.5), 1e-6);
  EXPECT_EQ(count_of(*mesh, "flipped_triangles"), 0u);
  for (std::size_t v = 0; v < 8; ++v) EXPECT_GT(glm::dot(mesh->normals[v], mesh->positions[v]), 0.4f);
}

TEST(Prepare, ExtremeScalesAndOffsetsGiveTheSameMesh) {
  const Result<Mesh> plain = prepared(cube());
  for (const RawModel& raw :
       {cube(1e-15), cube(1e20), cube(1, glm::dvec3(1e7)), cube(1e-100), cube(1, glm::dvec3(-1e7))}) {
    const Result<Mesh> mesh = prepared(raw);
    ASSERT_TRUE(mesh.ok()) << mesh.status().message;
    expect_groomable(*mesh);
    EXPECT_EQ(mesh->triangles, plain->triangles);
    for (std::size_t v = 0; v < 8; ++v) {
      EXPECT_NEAR(glm::length(mesh->positions[v] - plain->positions[v]), 0, 1e-6);
      EXPECT_NEAR(glm::length(mesh->normals[v] - plain->normals[v]), 0, 1e-6);
    }
  }
}

TEST(Prepare, RefusalsNameTheLimit) {
  EXPECT_EQ(prepared(cube(1.1e20)).status().limit, "at most 1e20");
  const Result<Mesh> coarse = prepared(cube(1, glm::dvec3(1e4)), true);
  ASSERT_FALSE(coarse.ok());
  EXPECT_NE(coarse.status().message.find("precision"), std::string::npos);
  EXPECT_TRUE(prepared(cube(1, glm::dvec3(1e3)), true).ok());
  EXPECT_TRUE(prepared(cube(1, glm::dvec3(1e4)), false).ok());
  EXPECT_FALSE(prepared({}).ok());
  EXPECT_FALSE(prepare(cube(), {.front = Axis::minus_y}).ok());
  RawModel many;
  many.positions = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}};
  many.face_sizes = {2'000'003};
  many.corners.assign(2'000'003, 0);
  EXPECT_NE(prepared(many).status().limit.find("2000000"), std::string::npos);
}

TEST(Prepare, TurnsUpAndFront) {
  // A long arrow along +X with its fin towards +Z: up is Z, front is X.
  const RawModel raw = model_of({{0, 0, 0}, {4, 0, 0}, {0, 0, 1}}, {{0, 1, 2}});
  const Result<Mesh> mesh = prepare(raw, {.up = Axis::plus_z, .front = Axis::plus_x});
  ASSERT_TRUE(mesh.ok());
  EXPECT_EQ(mesh->report.bounds.max, glm::dvec3(0, 1, 4));
  EXPECT_EQ(mesh->report.bounds.min, glm::dvec3(0, 0, 0));
  // A rotation and no mirror image: outward winding stays outward.
  for (const auto& [up, front] : {std::pair{Axis::minus_z, Axis::plus_x}, std::pair{Axis::plus_x, Axis::minus_y}}) {
    const Result<Mesh> turned = prepare(cube(), {.up = up, .front = front});
    ASSERT_TRUE(turned.ok());
    EXPECT_EQ(count_of(*turned, "flipped_triangles"), 0u);
  }
}

TEST(Prepare, WeldsEqualPositionsAlsoAcrossTheSignOfZero) {
  const RawModel raw = model_of({{-1, -3, -3}, {-1, -2, 0}, {-1, 0, -2}, {-1, -2, -0.0}, {-1, -0.0, -2}, {-1, 1, 1}},
                                {{0, 1, 2}, {4, 3, 5}});
  const Result<Mesh> mesh = prepared(raw);
  ASSERT_TRUE(mesh.ok());
  EXPECT_EQ(mesh->positions.size(), 4u);
  EXPECT_EQ(count_of(*mesh, "welded_vertices"), 2u);
  EXPECT_EQ(mesh->report.parts, 1u);
}

TEST(Prepare, DropsWhatIsNoFace) {
  const double nan = std::numeric_limits<double>::quiet_NaN(), inf = std::numeric_limits<double>::infinity();
  RawModel raw = model_of(
      {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {nan, 0, 0}, {0, inf, 0}, {2, 0, 0}, {1, 0, 0}},
      {{0, 1, 2}, {0, 1, 3}, {4, 1, 2}, {0, 1}, {0, 1, no_position}, {0, 1, 5}, {0, 1, 6}, {2, 0, 1}, {1, 0, 2}});
  const Result<Mesh> mesh = prepared(raw);
  ASSERT_TRUE(mesh.ok());
  expect_groomable(*mesh);
  EXPECT_EQ(mesh->triangles.size(), 1u);
  EXPECT_EQ(mesh->positions.size(), 3u);
  EXPECT_EQ(count_of(*mesh, "invalid_faces"), 1u);
  EXPECT_EQ(count_of(*mesh, "bad_indices"), 1u);
  EXPECT_EQ(count_of(*mesh, "non_finite_faces"), 2u);
  EXPECT_EQ(count_of(*mesh, "degenerate_faces"), 2u);
  EXPECT_EQ(count_of(*mesh, "repeated_faces"), 2u);
}

TEST(Prepare, SliversAreKeptAndFramed) {
  const Result<Mesh> mesh = prepared(model_of({{0, 0, 0}, {1, 0, 0}, {0.5, 1e-12, 0}}, {{0, 1, 2}}));
  ASSERT_TRUE(mesh.ok());
  expect_groomable(*mesh);
}

TEST(Prepare, WindingIsRepaired) {
  RawModel raw = ball(8);
  std::swap(raw.corners[30], raw.corners[31]);
  Result<Mesh> mesh = prepared(raw);
  ASSERT_TRUE(mesh.ok());
  EXPECT_EQ(count_of(*mesh, "flipped_triangles"), 1u);
  EXPECT_GT(signed_volume(*mesh), 0);
  for (std::size_t f = 0; f < raw.face_sizes.size(); ++f) std::swap(raw.corners[3 * f], raw.corners[3 * f + 1]);
  mesh = prepared(raw);
  EXPECT_EQ(count_of(*mesh, "flipped_triangles"), raw.face_sizes.size() - 1);
  EXPECT_GT(signed_volume(*mesh), 0);
  for (std::size_t v = 0; v < mesh->positions.size(); ++v) {
    EXPECT_GT(glm::dot(glm::normalize(mesh->positions[v]), mesh->normals[v]), 0.95f);
  }
}

TEST(Prepare, APlaneKeepsTheWindingOfMostOfIt) {
  const std::vector<glm::dvec3> positions = {{0, 0, 0}, {1, 0, 0}, {2, 0, 0}, {0, 0, 1}, {1, 0, 1}, {2, 0, 1}};
  const Result<Mesh> mesh = prepared(model_of(positions, {{0, 3, 1}, {1, 3, 4}, {1, 2, 4}, {2, 4, 5}}));
  ASSERT_TRUE(mesh.ok());
  EXPECT_EQ(count_of(*mesh, "flipped_triangles"), 1u);
  for (const glm::vec3& normal : mesh->normals) EXPECT_NEAR(normal.y, 1, 1e-6);
}

TEST(Prepare, ConcaveAndKeyholePolygonsKeepTheirArea) {
  // An L of area 3 in both directions around, and a square with a square hole joined by a bridge: 16 - 4.
  const std::vector<glm::dvec3> l = {{0, 0, 0}, {2, 0, 0}, {2, 1, 0}, {1, 1, 0}, {1, 2, 0}, {0, 2, 0}};
  for (const auto& order :
       {std::vector<std::uint32_t>{0, 1, 2, 3, 4, 5}, std::vector<std::uint32_t>{3, 2, 1, 0, 5, 4}}) {
    const Result<Mesh> mesh = prepared(model_of(l, {order}));
    ASSERT_TRUE(mesh.ok());
    EXPECT_EQ(mesh->triangles.size(), 4u);
    EXPECT_NEAR(area(*mesh), 3, 1e-6);
  }
  const Result<Mesh> hole =
      prepared(model_of({{0, 0, 0}, {4, 0, 0}, {4, 4, 0}, {0, 4, 0}, {1, 1, 0}, {1, 3, 0}, {3, 3, 0}, {3, 1, 0}},
                        {{0, 1, 2, 3, 0, 4, 5, 6, 7, 4}}));
  ASSERT_TRUE(hole.ok());
  EXPECT_NEAR(area(*hole), 12, 1e-5);
}

TEST(Prepare, CollinearCornersOfPolygonsStayConnected) {
  const std::vector<glm::dvec3> p = {{0, 0, 0}, {1, 0, 0}, {2, 0, 0}, {2, 1, 0}, {0, 1, 0}};
  const Result<Mesh> mesh = prepared(model_of(p, {{0, 1, 2, 3, 4}}));
  ASSERT_TRUE(mesh.ok());
  EXPECT_EQ(mesh->positions.size(), 5u);
  EXPECT_NEAR(area(*mesh), 2, 1e-6);
}

TEST(Prepare, LargePolygonsTakeNoCubicTime) {
  RawModel raw;
  constexpr std::uint32_t corners = 100'000;
  for (std::uint32_t i = 0; i < corners; ++i) {
    const double angle = 2 * 3.14159265358979 * i / corners, radius = i % 2 ? 1 : 0.5;
    raw.positions.emplace_back(radius * std::cos(angle), radius * std::sin(angle), 0);
    raw.corners.push_back(i);
  }
  raw.face_sizes = {corners};
  const Result<Mesh> mesh = prepared(raw);
  ASSERT_TRUE(mesh.ok());
  expect_groomable(*mesh);
}

TEST(Prepare, TangentsPointTailwards) {
  const Result<Mesh> mesh = prepared(ball(16));
  ASSERT_TRUE(mesh.ok());
  for (std::size_t v = 0; v < mesh->positions.size(); ++v) {
    const glm::vec3 n = mesh->normals[v], t = mesh->tangents[v];
    EXPECT_NEAR(t.z, -std::sqrt(std::max(0.0f, 1 - n.z * n.z)), 1e-3);
    EXPECT_TRUE(t.z < -1e-4f || t.y < -0.99f) << "on the nose and the tail it points down";
  }
}

TEST(Prepare, CancellingNormalsFallBackToATriangle) {
  // Two triangles back to back that differ in one distant vertex: at the shared vertices their areas cancel.
  const Result<Mesh> mesh =
      prepared(model_of({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 1, 1e-13}}, {{0, 1, 2}, {1, 0, 3}}));
  ASSERT_TRUE(mesh.ok());
  expect_groomable(*mesh);
}

TEST(Prepare, LooksSurviveWelding) {
  // Two triangles share an edge, but not the texture coordinates along it.
  RawModel raw = model_of({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {1, 1, 0}}, {{0, 1, 2}, {2, 1, 3}});
  raw.corner_uv = {{0, 0}, {1, 0}, {0, 1}, {5, 1}, {6, 0}, {6, 1}};
  raw.corner_colour.assign(6, {0.5f, 1, 1, 1});
  raw.corner_colour[4] = glm::vec4(std::numeric_limits<float>::quiet_NaN());
  raw.materials = {{{1, 0.5f, 1}, 0}};
  raw.face_material = {0, 0};
  raw.images = {{1, 1, {9, 9, 9, 255}}};
  const Result<Mesh> mesh = prepared(raw);
  ASSERT_TRUE(mesh.ok());
  ASSERT_EQ(mesh->corners.size(), 2u);
  for (std::size_t t = 0; t < 2; ++t) {
    for (int k = 0; k < 3; ++k) {
      const LookCorner& look = mesh->corners[t][static_cast<std::size_t>(k)];
      EXPECT_EQ(look.image, 0);
      EXPECT_EQ(look.uv.x >= 5, t == 1);
      EXPECT_TRUE(look.colour == glm::vec3(0.5f, 0.5f, 1) || look.colour == glm::vec3(1, 0.5f, 1));
    }
  }
  raw.corner_uv[0] = glm::dvec2(std::numeric_limits<double>::quiet_NaN());
  EXPECT_EQ(prepared(raw)->corners[0][1].image, -1) << "a triangle is textured as a whole";
  EXPECT_TRUE(prepared(cube())->corners.empty());
}

/// A cube with one material on its first two faces and another on the rest.
RawModel cube_of(const char* first, const char* rest) {
  RawModel raw = cube();
  raw.materials = {{{1, 1, 1}, -1, first}, {{1, 1, 1}, -1, rest}, {{1, 1, 1}, -1, rest}};
  raw.face_material.assign(raw.face_sizes.size(), 1);
  raw.face_material[0] = raw.face_material[1] = 0, raw.face_material.back() = 2;
  return raw;
}

TEST(Prepare, MaterialsAreReportedByName) {
  const Result<Mesh> mesh = prepared(cube_of("Claw_L.001", "Fur"));
  ASSERT_TRUE(mesh.ok());
  const std::size_t all = mesh->triangles.size();
  const std::vector<MaterialReport> wanted = {{"Claw_L.001", 2 * all / cube().face_sizes.size(), true},
                                              {"Fur", all - 2 * all / cube().face_sizes.size(), false}};
  EXPECT_EQ(mesh->report.materials, wanted) << "two materials of one name are one";
  ASSERT_EQ(mesh->materials.size(), all);
  EXPECT_EQ(mesh->materials.front(), 0);
  EXPECT_EQ(mesh->materials.back(), 1);
  EXPECT_TRUE(prepared(cube())->report.materials.empty());
  EXPECT_TRUE(prepared(cube_of("", ""))->materials.empty());
}

TEST(Prepare, WhatIsAllBareIsFurred) {
  const Result<Mesh> mesh = prepared(cube_of("Eye_L", "Eye_R"));
  ASSERT_TRUE(mesh.ok());
  ASSERT_EQ(mesh->report.materials.size(), 2u);
  for (const MaterialReport& material : mesh->report.materials) EXPECT_FALSE(material.bare) << material.name;
}

TEST(Prepare, NoMoreMaterialsAreNamedThanTheLimit) {
  RawModel raw = cube();
  RawModel many;
  for (std::size_t k = 0; k < limits::named_materials + 3; ++k) {
    for (const glm::dvec3& p : raw.positions)
      many.positions.push_back(p + glm::dvec3(3.0 * static_cast<double>(k), 0, 0));
    for (const std::uint32_t corner : raw.corners)
      many.corners.push_back(corner + static_cast<std::uint32_t>(k * raw.positions.size()));
    many.face_sizes.insert(many.face_sizes.end(), raw.face_sizes.begin(), raw.face_sizes.end());
    many.face_material.insert(many.face_material.end(), raw.face_sizes.size(), static_cast<std::uint16_t>(k));
    many.materials.push_back({{1, 1, 1}, -1, "m" + std::to_string(k)});
  }
  const Result<Mesh> mesh = prepared(many);
  ASSERT_TRUE(mesh.ok());
  EXPECT_EQ(mesh->report.materials.size(), limits::named_materials);
  EXPECT_EQ(mesh->materials.back(), no_material);
}

TEST(Materials, NamesSayWhatIsBare) {
  for (const char* name :
       {"Eye", "eyes", "leftEye", "MAT_Eyeball.002", "M_Teeth", "hoof-front", "claws2", "Beak", "Horn_L"})
    EXPECT_TRUE(names_bare_part(name)) << name;
  for (const char* name :
       {"", "Fur", "eyebrow", "Eye_Lashes", "eyelid", "Snail", "thorn", "Unicorn", "preying", "body"})
    EXPECT_FALSE(names_bare_part(name)) << name;
}

TEST(Prepare, LengthScaleFollowsItsVertex) {
  RawModel raw = model_of({{9, 9, 9}, {0, 0, 0}, {1, 0, 0}, {0, 1, 0}}, {{3, 1, 2}});
  raw.length_scale = {4, 1, 2, 3};
  const Result<Mesh> mesh = prepared(raw);
  ASSERT_TRUE(mesh.ok());
  for (std::size_t v = 0; v < 3; ++v) {
    const glm::dvec3 p = mesh->to_model(glm::dvec3(mesh->positions[v]));
    EXPECT_NEAR(mesh->length_scale[v], 1 + p.x + 2 * p.y, 1e-5);
  }
}

}  // namespace
}  // namespace pelage::prepare_test
