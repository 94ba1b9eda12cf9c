// Splitting triangles keeps the shape, opens no cracks, and keeps positions on the sample tile linear.
#include "server/patches/subdivide.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numeric>
#include <set>
#include <string>

#include "base/limits.h"
#include "base/random.h"
#include "server/builtin/builtin.h"
#include "server/surface/adjacency.h"
#include "tests/unit/surface/mesh_checks.h"
#include "tests/unit/surface/shapes.h"

namespace pelage::subdivide_test {
namespace {

ChosenTriangles all_of(const Mesh& mesh) { return {{0, static_cast<std::uint32_t>(mesh.triangles.size())}}; }

ChosenTriangles some_of(const Mesh& mesh, Random& random, double share) {
  ChosenTriangles chosen;
  for (std::uint32_t t = 0; t < mesh.triangles.size(); ++t) {
    if (random.uniform() >= share) continue;
    if (!chosen.empty() && chosen.back().end == t)
      ++chosen.back().end;
    else
      chosen.push_back({t, t + 1});
  }
  return chosen;
}

double area_of(const Mesh& mesh) {
  double twice = 0;
  for (const glm::uvec3& t : mesh.triangles) {
    const glm::dvec3 a(mesh.positions[t.x]), b(mesh.positions[t.y]), c(mesh.positions[t.z]);
    twice += glm::length(glm::cross(b - a, c - a));
  }
  return twice / 2;
}

struct Edges {
  long count = 0;
  std::vector<std::size_t> by_triangles = std::vector<std::size_t>(8, 0);  // number of edges with 1, 2, ... triangles
};

Edges edges_of(const Mesh& mesh) {
  Edges edges;
  for_each_edge(sorted_sides(mesh.triangles), [&](std::span<const Side> edge) {
    ++edges.count, ++edges.by_triangles[std::min<std::size_t>(edge.size(), 7)];
  });
  return edges;
}

long euler(const Mesh& mesh) {
  return static_cast<long>(mesh.positions.size()) - edges_of(mesh).count + static_cast<long>(mesh.triangles.size());
}

/// Length of the boundary, which grows if a crack opens.
double boundary_of(const Mesh& mesh) {
  double sum = 0;
  for_each_edge(sorted_sides(mesh.triangles), [&](std::span<const Side> edge) {
    if (edge.size() == 1)
      sum += glm::distance(glm::dvec3(mesh.positions[edge[0].low]), glm::dvec3(mesh.positions[edge[0].high]));
  });
  return sum;
}

void expect_shares(const Mesh& mesh, const PatchMap& map) {
  std::vector<glm::dvec3> sums(mesh.triangles.size(), glm::dvec3(0));
  for (std::size_t i = 0; i < map.patch_triangles.size(); ++i) {
    const PatchTriangle& patch_triangle = map.patch_triangles[i];
    if (i > 0) {
      const PatchTriangle& before = map.patch_triangles[i - 1];
      ASSERT_LT(std::pair(before.triangle, before.patch), std::pair(patch_triangle.triangle, patch_triangle.patch));
    }
    for (int k = 0; k < 3; ++k) {
      const PatchPoint& point = map.points[patch_triangle.points[k]];
      ASSERT_EQ(point.vertex, mesh.triangles[patch_triangle.triangle][k]);
      ASSERT_EQ(point.patch, patch_triangle.patch);
      ASSERT_NEAR(glm::length(point.axis), 1, 1e-5);
      ASSERT_NEAR(glm::dot(point.axis, mesh.normals[point.vertex]), 0, 1e-5);
      sums[patch_triangle.triangle][k] += double{point.weight};
    }
  }
  for (const glm::dvec3& sum : sums) {
    for (int k = 0; k < 3; ++k) ASSERT_NEAR(sum[k], 1, 1e-5);
  }
  for (std::size_t i = 1; i < map.points.size(); ++i)
    ASSERT_LE(std::pair(map.points[i - 1].patch, map.points[i - 1].vertex),
              std::pair(map.points[i].patch, map.points[i].vertex));
}

Mesh built_in(Builtin shape, int triangles) { return *shapes::prepared(make_builtin({shape, triangles})); }

TEST(Subdivide, AWholeMeshHasFourTimesTheTrianglesAndTheSameShape) {
  for (const Builtin shape : {Builtin::sphere, Builtin::torus, Builtin::plane, Builtin::knot, Builtin::creature}) {
    const Mesh mesh = built_in(shape, 600);
    const PatchMap patches = lay_patches(mesh);
    const auto finer = subdivide(mesh, patches, all_of(mesh));
    ASSERT_TRUE(finer.ok());
    EXPECT_EQ(finer->mesh.triangles.size(), 4 * mesh.triangles.size());
    EXPECT_EQ(finer->parents.size(), static_cast<std::size_t>(edges_of(mesh).count));
    EXPECT_EQ(euler(finer->mesh), euler(mesh));
    EXPECT_NEAR(area_of(finer->mesh), area_of(mesh), 1e-6);
    EXPECT_NEAR(boundary_of(finer->mesh), boundary_of(mesh), 1e-6);
    expect_groomable(finer->mesh);
    expect_shares(finer->mesh, finer->patches);
    for (std::size_t v = 0; v < mesh.positions.size(); ++v) ASSERT_EQ(finer->mesh.positions[v], mesh.positions[v]);
  }
}

TEST(Subdivide, RandomChoicesOpenNoCrack) {
  Random random(11, 0);
  for (int round = 0; round < 40; ++round) {
    const Builtin shapes_of[] = {Builtin::sphere, Builtin::torus, Builtin::plane};
    const Mesh mesh = built_in(shapes_of[round % 3], 60 + 20 * round);
    const PatchMap patches = lay_patches(mesh);
    const ChosenTriangles chosen = some_of(mesh, random, random.uniform());
    const auto finer = subdivide(mesh, patches, chosen);
    ASSERT_TRUE(finer.ok());
    ASSERT_EQ(euler(finer->mesh), euler(mesh)) << round;
    ASSERT_NEAR(area_of(finer->mesh), area_of(mesh), 1e-6);
    ASSERT_NEAR(boundary_of(finer->mesh), boundary_of(mesh), 1e-6);
    const Edges edges = edges_of(finer->mesh);
    ASSERT_EQ(std::accumulate(edges.by_triangles.begin() + 3, edges.by_triangles.end(), std::size_t{0}), 0u);
    std::size_t min = mesh.triangles.size();
    for (const TriangleRun run : chosen) min += 3 * (run.end - run.begin);
    ASSERT_GE(finer->mesh.triangles.size(), min);
    expect_shares(finer->mesh, finer->patches);
    const auto twice = subdivide(finer->mesh, finer->patches, some_of(finer->mesh, random, 0.3));
    ASSERT_EQ(euler(twice->mesh), euler(mesh));
    expect_shares(twice->mesh, twice->patches);
  }
}

TEST(Subdivide, PositionsOnTheTileAreTheMeansOfTheirParents) {
  const Mesh mesh = built_in(Builtin::creature, 800);
  const PatchMap patches = lay_patches(mesh);
  const auto finer = subdivide(mesh, patches, all_of(mesh));
  std::set<std::tuple<std::uint32_t, std::uint32_t, float, float>> known;  // patch, vertex, uv
  for (const PatchPoint& point : patches.points) known.emplace(point.patch, point.vertex, point.uv.x, point.uv.y);
  const auto old = static_cast<std::uint32_t>(mesh.positions.size());
  std::size_t middles = 0;
  for (const PatchPoint& point : finer->patches.points) {
    if (point.vertex < old) {
      ASSERT_TRUE(known.count({point.patch, point.vertex, point.uv.x, point.uv.y}));
      continue;
    }
    const glm::uvec2 parents = finer->parents[point.vertex - old];
    const auto of = [&](std::uint32_t vertex) {
      return *std::find_if(patches.points.begin(), patches.points.end(),
                           [&](const PatchPoint& p) { return p.patch == point.patch && p.vertex == vertex; });
    };
    const PatchPoint a = of(parents.x), b = of(parents.y);
    ASSERT_NEAR(glm::distance(point.uv, (a.uv + b.uv) * 0.5f), 0, 1e-6);
    ASSERT_NEAR(point.weight, (a.weight + b.weight) / 2, 1e-6);
    if (++middles > 2000) break;
  }
  EXPECT_GT(middles, 1000u);
}

TEST(Subdivide, CornersKeepTheirSeams) {
  RawModel raw = shapes::model_of({{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}}, {{0, 1, 2}, {0, 2, 3}});
  raw.corner_uv = {{0, 0}, {1, 0}, {1, 1}, {5, 5}, {6, 6}, {5, 6}};  // a seam along the diagonal
  const Mesh mesh = *shapes::prepared(raw);
  ASSERT_EQ(mesh.texture_uv.size(), 2u);
  const auto finer = subdivide(mesh, *own_uv_patches(mesh), all_of(mesh));
  ASSERT_TRUE(finer.ok());
  EXPECT_EQ(finer->mesh.texture_uv.size(), 8u);
  for (std::size_t t = 0; t < 8; ++t) {
    for (std::size_t k = 0; k < 3; ++k) {
      const glm::vec3 p = finer->mesh.positions[finer->mesh.triangles[t][static_cast<int>(k)]];
      const glm::dvec3 model = mesh.to_model(glm::dvec3(p));
      const glm::vec2 expected = glm::vec2(model) + (t < 4 ? 0.0f : 5.0f);
      EXPECT_NEAR(glm::distance(finer->mesh.texture_uv[t][k], expected), 0, 1e-5) << t << " " << k;
    }
  }
  expect_shares(finer->mesh, finer->patches);
}

TEST(Subdivide, OneTriangleManyTimesAndEdgesWithoutAPointBetween) {
  Mesh mesh = *shapes::prepared(shapes::model_of({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}, {{0, 1, 2}}));
  PatchMap patches = lay_patches(mesh);
  for (int level = 1; level <= 6; ++level) {
    auto finer = subdivide(mesh, patches, all_of(mesh));
    ASSERT_TRUE(finer.ok());
    mesh = std::move(finer->mesh), patches = std::move(finer->patches);
  }
  EXPECT_EQ(mesh.triangles.size(), 4096u);
  EXPECT_EQ(euler(mesh), 1);
  expect_groomable(mesh);
  expect_shares(mesh, patches);
  // Two corners that differ by one bit: the side between them is not split, so the triangle becomes 3 instead of 4.
  Mesh thin = *shapes::prepared(shapes::model_of({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}, {{0, 1, 2}}));
  thin.positions[1] = thin.positions[0];
  thin.positions[1].x = std::nextafter(thin.positions[0].x, 1.0f);
  const auto finer = subdivide(thin, lay_patches(thin), all_of(thin));
  EXPECT_EQ(finer->mesh.triangles.size(), 3u);
  EXPECT_EQ(euler(finer->mesh), 1);
}

TEST(Subdivide, RefusesTooManyTrianglesAndOnesThatAreNotThere) {
  const Mesh mesh = built_in(Builtin::sphere, 510'000);
  const PatchMap none;  // not used
  const auto many = subdivide(mesh, none, all_of(mesh));
  ASSERT_FALSE(many.ok());
  EXPECT_EQ(many.status().limit, "at most " + std::to_string(limits::model_triangles));
  const Mesh small = built_in(Builtin::sphere, 100);
  EXPECT_FALSE(subdivide(small, lay_patches(small), {{5, 100'000}}).ok());
  EXPECT_FALSE(subdivide(small, lay_patches(small), {{5, 5}}).ok());
  const auto same = subdivide(small, lay_patches(small), {});
  EXPECT_EQ(same->mesh.triangles, small.triangles);
}

}  // namespace
}  // namespace pelage::subdivide_test
