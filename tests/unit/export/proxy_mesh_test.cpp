#include "server/export/proxy_mesh.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>
#include <set>

#include "base/limits.h"
#include "server/builtin/builtin.h"
#include "server/groom/standing_fur.h"
#include "tests/support/glb_file.h"
#include "tests/unit/surface/shapes.h"

namespace pelage {
namespace {

using testing::GlbFile;

constexpr double far_away = 1e9;

RawModel moved(RawModel raw, glm::dvec3 by, double scale = 1) {
  for (glm::dvec3& p : raw.positions) p = p * scale + by;
  return raw;
}

/// Gives each triangle three vertices of its own, like a file with a seam at every edge.
RawModel torn(const RawModel& raw) {
  RawModel result;
  for (const std::uint32_t corner : raw.corners) result.positions.push_back(raw.positions[corner]);
  result.face_sizes = raw.face_sizes;
  for (std::uint32_t k = 0; k < raw.corners.size(); ++k) result.corners.push_back(k);
  for (std::uint32_t k = 0; k < raw.corners.size(); ++k) result.corner_uv.emplace_back(k % 7, k % 5);
  return result;
}

/// Expects a valid glTF file with finite numbers, unit normals, and bounds that contain every position.
void expect_sound(const GlbFile& file) {
  const auto positions = file.vectors("POSITION"), normals = file.vectors("NORMAL");
  ASSERT_EQ(positions.size(), normals.size());
  const nlohmann::json& bounds = file.json["accessors"][file.primitive()["attributes"]["POSITION"].get<std::size_t>()];
  glm::vec3 low(1e38f), high(-1e38f);
  for (const glm::vec3& p : positions) low = glm::min(low, p), high = glm::max(high, p);
  for (int k = 0; k < 3; ++k) {
    EXPECT_EQ(bounds["min"][k].get<float>(), low[k]);
    EXPECT_EQ(bounds["max"][k].get<float>(), high[k]);
    EXPECT_TRUE(std::isfinite(low[k]) && std::isfinite(high[k]));
  }
  for (const glm::vec3& n : normals) ASSERT_NEAR(glm::length(n), 1, 1e-5);
  const auto indices = file.indices();
  ASSERT_EQ(indices.size() % 3, 0u);
  ASSERT_FALSE(indices.empty());
  EXPECT_EQ(file.has_short_indices(), positions.size() <= 65535);
  std::set<std::uint32_t> used(indices.begin(), indices.end());
  EXPECT_EQ(used.size(), positions.size());
  EXPECT_LT(*used.rbegin(), positions.size());
  for (const char* turn : {"rotation", "scale", "matrix"}) EXPECT_FALSE(file.json["nodes"][0].contains(turn)) << turn;
}

GlbFile file_of(const Mesh& mesh, std::size_t triangles) {
  const Result<ProxyMesh> proxy = simplify(mesh, triangles);
  EXPECT_TRUE(proxy.ok());
  GlbFile file(glb_of(*proxy));
  expect_sound(file);
  return file;
}

/// The smallest and largest distance from `centre` over corners and midpoints of edges and triangles.
std::pair<double, double> radii(const GlbFile& file, glm::dvec3 centre) {
  const auto positions = file.vectors("POSITION");
  const auto indices = file.indices();
  double low = 1e300, high = 0;
  for (std::size_t k = 0; k < indices.size(); k += 3) {
    const glm::dvec3 a(positions[indices[k]]), b(positions[indices[k + 1]]), c(positions[indices[k + 2]]);
    for (const glm::dvec3 p : {a, b, c, (a + b) / 2., (b + c) / 2., (c + a) / 2., (a + b + c) / 3.}) {
      const double radius = glm::length(p + file.translation() - centre);
      low = std::min(low, radius), high = std::max(high, radius);
    }
  }
  return {low, high};
}

TEST(ProxyMesh, ASimplerBallIsABall) {
  const Mesh ball = *shapes::prepared(shapes::ball(150));
  ASSERT_GT(ball.triangles.size(), 80'000u);
  const GlbFile file = file_of(ball, 2000);
  EXPECT_LE(file.indices().size() / 3, 2000u);
  EXPECT_GT(file.indices().size() / 3, 1500u);
  const auto [low, high] = radii(file, glm::dvec3(0));
  EXPECT_GT(low, .98);
  EXPECT_LT(high, 1 + 1e-6);
}

TEST(ProxyMesh, NormalsPointOutAndTrianglesAreWoundOutwards) {
  const GlbFile file = file_of(*shapes::prepared(shapes::ball(60)), 1000);
  const auto positions = file.vectors("POSITION"), normals = file.vectors("NORMAL");
  for (std::size_t v = 0; v < positions.size(); ++v) ASSERT_GT(glm::dot(positions[v], normals[v]), .99f);
  const auto indices = file.indices();
  for (std::size_t k = 0; k < indices.size(); k += 3) {
    const glm::vec3 a = positions[indices[k]], b = positions[indices[k + 1]], c = positions[indices[k + 2]];
    ASSERT_GT(glm::dot(glm::cross(b - a, c - a), a + b + c), 0);
  }
}

TEST(ProxyMesh, FarFromTheOriginNothingIsLost) {
  const glm::dvec3 offset(far_away, -far_away / 3, 7);
  const GlbFile file = file_of(*shapes::prepared(moved(shapes::ball(60), offset, 3)), 1000);
  EXPECT_NEAR(file.translation().x, far_away, 1e-6);
  const auto [low, high] = radii(file, offset);
  EXPECT_GT(low, 3 * .97);
  EXPECT_LT(high, 3 * (1 + 1e-5));
}

TEST(ProxyMesh, SeamsDoNotStopTheSimplifier) {
  const Mesh whole = *shapes::prepared(shapes::ball(60)), seamed = *shapes::prepared(torn(shapes::ball(60)));
  ASSERT_FALSE(seamed.texture_uv.empty());
  const GlbFile file = file_of(seamed, 1000);
  EXPECT_EQ(file.indices(), file_of(whole, 1000).indices());
  EXPECT_LE(file.indices().size() / 3, 1000u);
  EXPECT_GT(radii(file, glm::dvec3(0)).first, .97);
}

TEST(ProxyMesh, AModelWithFewTrianglesIsSentAsItIs) {
  const Mesh cube = *shapes::prepared(shapes::cube(2, {1, 2, 3}));
  const GlbFile file = file_of(cube, 12);
  EXPECT_EQ(file.indices().size(), 36u);
  EXPECT_EQ(file.vectors("POSITION").size(), 8u);
  EXPECT_EQ(file.translation(), glm::dvec3(2, 3, 4));
  for (const glm::vec3& p : file.vectors("POSITION")) EXPECT_NEAR(glm::length(p), std::sqrt(3), 1e-6);
}

TEST(ProxyMesh, KeepsAtLeastOneTriangle) {
  const Mesh mesh = *shapes::prepared(shapes::model_of({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}, {{0, 1, 2}}));
  for (const std::size_t triangles : {100, 1, 0}) EXPECT_EQ(file_of(mesh, triangles).indices().size(), 3u);
  file_of(*shapes::prepared(shapes::ball(20)), 0);  // still leaves something
}

TEST(ProxyMesh, TrianglesWithoutAreaDoNoHarm) {
  Mesh mesh = *shapes::prepared(shapes::ball(20));
  const std::size_t whole = mesh.triangles.size();
  for (std::size_t t = 0; t < whole; t += 3) {  // 32-bit rounding can merge different vertices
    const auto copy = static_cast<std::uint32_t>(mesh.positions.size());
    mesh.positions.push_back(mesh.positions[mesh.triangles[t].x]);
    mesh.normals.push_back(mesh.normals[mesh.triangles[t].x]);
    mesh.triangles.emplace_back(mesh.triangles[t].x, copy, mesh.triangles[t].y);
  }
  const GlbFile file = file_of(mesh, 300);
  EXPECT_LE(file.indices().size() / 3, 300u);
  EXPECT_GT(radii(file, glm::dvec3(0)).first, .9);
  file_of(mesh, mesh.triangles.size());
  EXPECT_EQ(file_of(mesh, mesh.triangles.size() - 1).indices().size() / 3, whole) << "without them it has few enough";
}

TEST(ProxyMesh, WhatCannotBeSimplerIsSentAllTheSame) {
  RawModel fan;  // triangles around one edge; each has two further edges of its own
  constexpr int leaves = 200;
  fan.positions = {{0, 0, 0}, {0, 1, 0}};
  for (std::uint32_t k = 0; k < leaves; ++k) {
    const double turn = 2 * 3.14159265358979 * k / leaves;
    fan.positions.emplace_back(std::cos(turn), .5, std::sin(turn));
    fan.face_sizes.push_back(3);
    fan.corners.insert(fan.corners.end(), {0, 1, k + 2});
  }
  EXPECT_EQ(file_of(*shapes::prepared(fan), 100).indices().size() / 3, leaves);
}

TEST(ProxyMesh, SimplifiesRandomTriangles) {  // the library ends the process where it is asked for what it does not do
  std::mt19937 random(7);
  const auto below = [&](std::size_t n) { return static_cast<std::uint32_t>(random() % n); };
  for (int turn = 0; turn < 3000; ++turn) {
    Mesh mesh;
    const std::size_t vertices = 3 + below(60), steps = 1 + below(8), triangles = 1 + below(300);
    for (std::size_t v = 0; v < vertices; ++v) {
      const glm::vec3 cell(below(steps), below(steps), below(steps));
      mesh.positions.push_back((below(2) ? 1.f : -1.f) * cell / static_cast<float>(steps));
    }
    mesh.normals.assign(vertices, {0, 1, 0});
    while (mesh.triangles.size() < triangles) {
      const glm::uvec3 t(below(vertices), below(vertices), below(vertices));
      if (t.x != t.y && t.y != t.z && t.z != t.x) mesh.triangles.push_back(t);
    }
    file_of(mesh, below(2 * triangles));
    ASSERT_FALSE(HasFailure()) << "turn " << turn;
  }
}

TEST(ProxyMesh, FurStandsWhereABrushReachesItsTips) {
  const Surface surface(*shapes::prepared(moved(shapes::ball(20), {3, 4, 5}, 7)));
  const Mesh& mesh = surface.mesh();
  FieldSet fields(static_cast<std::uint32_t>(mesh.positions.size()));
  for (std::uint32_t v = 0; v < fields.size(); ++v) {
    fields.set(Field::length, v, glm::vec4(v % 3 == 0 ? 0.f : .2f));
    fields.set(Field::direction, v, glm::vec4(.4f, -.3f, 0, 0));
  }
  const ProxyMesh proxy = *simplify(mesh, mesh.triangles.size());
  const ProxyFur fur = fur_on(proxy, mesh, fields, std::vector<NamedCoat>(1));
  const GlbFile file(glb_of(proxy, &fur));
  const auto positions = file.vectors("POSITION"), tips = file.vectors("_FUR_TIP"),
             middles = file.vectors("_FUR_MIDDLE");
  const Coat coat;
  const StandingFur standing(surface, fields, coat);
  for (std::size_t k = 0; k < positions.size(); ++k) {
    const glm::dvec3 tip = mesh.to_internal(glm::dvec3(positions[k] + tips[k]) + file.translation());
    const auto reached = standing.within(tip, 1e-5);
    const auto own = [&](const auto& one) { return one.vertex == proxy.vertices[k]; };
    ASSERT_TRUE(std::any_of(reached.begin(), reached.end(), own)) << k;
    EXPECT_EQ(glm::length(tips[k]) > 0, proxy.vertices[k] % 3 != 0);
    EXPECT_LE(glm::length(middles[k]), .1001 * mesh.size);
  }
}

TEST(ProxyMesh, IndicesAreAsShortAsTheyCanBe) {
  const Mesh large = *shapes::prepared(make_torus(150'000));
  EXPECT_TRUE(file_of(large, 100'000).has_short_indices());
  EXPECT_FALSE(file_of(large, 150'000).has_short_indices());
}

TEST(ProxyMesh, WorksAtAnySizeThatFloatsHold) {
  for (const double scale : {2e-30, 1e-9, 1e9, 1e19}) {
    const GlbFile file = file_of(*shapes::prepared(moved(shapes::ball(60), glm::dvec3(0), scale)), 1000);
    EXPECT_GT(radii(file, glm::dvec3(0)).first, .97 * scale);
  }
  const Mesh tiny = *shapes::prepared(moved(shapes::ball(20), glm::dvec3(0), .1 * limits::proxy_size));
  EXPECT_EQ(simplify(tiny, 100).status().code, Code::invalid);
}

}  // namespace
}  // namespace pelage
