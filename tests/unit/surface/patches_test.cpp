// Patches cover the surface and keep its scale, also on models that people bring.
#include "server/patches/patches.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>
#include <iostream>
#include <set>
#include <string>

#include "server/builtin/builtin.h"
#include "server/patches/patch_cells.h"
#include "server/surface/value_noise.h"
#include "tests/unit/surface/shapes.h"
#include "tests/unit/surface/shared_models.h"

namespace pelage::patches_test {
namespace {

double area_of(const Mesh& mesh, std::uint32_t triangle) {
  const glm::uvec3& t = mesh.triangles[triangle];
  const glm::dvec3 a(mesh.positions[t.x]), b(mesh.positions[t.y]), c(mesh.positions[t.z]);
  return glm::length(glm::cross(b - a, c - a)) / 2;
}

/// Measures of a map's quality.
struct Quality {
  double area_factor = 0;  // area of patch triangles over area of the surface
  double flipped = 0;      // share of the patch triangles' area
  double stretched = 0;    // share of the patch triangles' area with a singular value outside [1/1.4, 1.4]
  double min_sum = 1e9, largest_sum = 0;  // smallest and largest sum of the weights at a corner
};

Quality quality_of(const Mesh& mesh, const PatchMap& map) {
  double surface = 0, patch_triangles = 0;
  Quality quality;
  std::vector<glm::dvec3> sums(mesh.triangles.size(), glm::dvec3(0));
  for (const PatchTriangle& patch_triangle : map.patch_triangles) {
    const double area = area_of(mesh, patch_triangle.triangle);
    const Stretch stretch = stretch_of(mesh, map, patch_triangle);
    patch_triangles += area;
    quality.flipped += stretch.flipped ? area : 0;
    quality.stretched += stretch.large > 1.4 || stretch.small < 1 / 1.4 ? area : 0;
    for (int k = 0; k < 3; ++k) sums[patch_triangle.triangle][k] += double{map.points[patch_triangle.points[k]].weight};
  }
  for (std::uint32_t t = 0; t < mesh.triangles.size(); ++t) {
    surface += area_of(mesh, t);
    for (int k = 0; k < 3; ++k) {
      quality.min_sum = std::min(quality.min_sum, sums[t][k]);
      quality.largest_sum = std::max(quality.largest_sum, sums[t][k]);
    }
  }
  quality.area_factor = patch_triangles / surface;
  quality.flipped /= patch_triangles, quality.stretched /= patch_triangles;
  return quality;
}

void expect_good(const Mesh& mesh, const PatchMap& map, double largest_factor) {
  const Quality quality = quality_of(mesh, map);
  EXPECT_NEAR(quality.min_sum, 1, 1e-5);
  EXPECT_NEAR(quality.largest_sum, 1, 1e-5);
  EXPECT_LE(quality.area_factor, largest_factor);
  EXPECT_LE(quality.flipped, 0.001);
  EXPECT_LE(quality.stretched, 0.02);
}

Mesh builtin(Builtin shape, int triangles) { return prepare(make_builtin({shape, triangles})).value(); }

TEST(Patches, APlaneIsOneAndKeepsItsLengths) {
  const Mesh mesh = builtin(Builtin::plane, 200);
  const PatchMap map = lay_patches(mesh);
  EXPECT_EQ(map.patches, 1u);
  EXPECT_EQ(map.patch_triangles.size(), mesh.triangles.size());
  for (const PatchTriangle& patch_triangle : map.patch_triangles) {
    const PatchPoint &a = map.points[patch_triangle.points.x], &b = map.points[patch_triangle.points.y];
    const glm::vec3 side = mesh.positions[b.vertex] - mesh.positions[a.vertex];
    EXPECT_NEAR(glm::length(b.uv - a.uv), glm::length(side), 1e-6);
    EXPECT_NEAR(b.uv.x - a.uv.x, glm::dot(side, a.axis), 1e-6) << "u runs along the axis";
    EXPECT_NEAR(glm::dot(a.axis, mesh.tangents[a.vertex]), 1, 1e-5) << "which is the fur's first direction";
    EXPECT_EQ(a.weight, 1);
  }
}

TEST(Patches, ABallIsCoveredByAFewThatStretchLittle) {
  const Mesh mesh = shapes::prepared(shapes::ball(40)).value();
  const PatchMap map = lay_patches(mesh);
  EXPECT_GE(map.patches, 4u);
  EXPECT_LE(map.patches, 16u);
  expect_good(mesh, map, 1.3);
}

TEST(Patches, CoverBuiltInsOfTheUsualSize) {
  for (const auto& [shape, triangles] : {std::pair{Builtin::creature, 5000},
                                         {Builtin::sphere, 5000},
                                         {Builtin::cloth, 1401},
                                         {Builtin::knot, 10'000},
                                         {Builtin::torus, 5000}}) {
    SCOPED_TRACE(static_cast<int>(shape));
    const Mesh mesh = builtin(shape, triangles);
    expect_good(mesh, lay_patches(mesh), 1.3);
  }
}

TEST(Patches, AxesLieInTheTangentPlaneAndPointWhereUGrows) {
  const Mesh mesh = builtin(Builtin::creature, 5000);
  const PatchMap map = lay_patches(mesh);
  double along = 0, count = 0;
  for (const PatchTriangle& patch_triangle : map.patch_triangles) {
    const PatchPoint &a = map.points[patch_triangle.points.x], &b = map.points[patch_triangle.points.y];
    const glm::vec3 side = mesh.positions[b.vertex] - mesh.positions[a.vertex];
    EXPECT_NEAR(glm::length(a.axis), 1, 1e-5);
    EXPECT_NEAR(glm::dot(a.axis, mesh.normals[a.vertex]), 0, 1e-4);
    along += double{glm::dot(side, a.axis) * (b.uv.x - a.uv.x)};
    count += double{(b.uv.x - a.uv.x) * (b.uv.x - a.uv.x)};
  }
  EXPECT_NEAR(along / count, 1, 0.1);
}

/// On a fine mesh the overlap is wider than a triangle, so weights between 0 and 1 are common.
TEST(Patches, OverlapsAreSoft) {
  const Mesh mesh = builtin(Builtin::sphere, 40'000);
  const PatchMap map = lay_patches(mesh);
  const auto soft = std::count_if(map.points.begin(), map.points.end(),
                                  [](const PatchPoint& point) { return point.weight > 0.1f && point.weight < 0.9f; });
  EXPECT_GT(static_cast<double>(soft), 0.1 * static_cast<double>(mesh.positions.size()));
}

TEST(Patches, NeighboursLieElsewhereOnTheTile) {
  const Mesh mesh = builtin(Builtin::plane, 2);
  Mesh two = mesh;  // with a copy beside it that touches it nowhere
  for (std::size_t v = 0; v < mesh.positions.size(); ++v) {
    two.positions.push_back(mesh.positions[v] + glm::vec3(0, 1, 0));
    two.normals.push_back(mesh.normals[v]), two.tangents.push_back(mesh.tangents[v]);
  }
  const auto first = static_cast<std::uint32_t>(mesh.positions.size());
  for (const glm::uvec3& t : mesh.triangles) two.triangles.push_back(t + first);
  const PatchMap map = lay_patches(two);
  ASSERT_EQ(map.patches, 2u);
  const glm::vec2 moved = map.points[map.points.size() / 2].uv - map.points[0].uv;
  EXPECT_GT(glm::length(moved), 0.01f);
}

TEST(Patches, SurviveWhatPreparationLetsThrough) {
  const RawModel triangle = shapes::model_of({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}, {{0, 1, 2}});
  const RawModel sliver = shapes::model_of({{0, 0, 0}, {1, 0, 0}, {0.5, 1e-9, 0}}, {{0, 1, 2}});
  const RawModel fan = shapes::model_of({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, -1, 0}, {0, 0, 1}},
                                        {{0, 1, 2}, {0, 1, 3}, {0, 1, 4}});  // three triangles on one edge
  for (const RawModel& raw : {triangle, sliver, fan, shapes::cube()}) {
    const Result<Mesh> mesh = shapes::prepared(raw);
    if (!mesh.ok()) continue;
    const PatchMap map = lay_patches(*mesh);
    const Quality quality = quality_of(*mesh, map);
    EXPECT_NEAR(quality.min_sum, 1, 1e-5);
    EXPECT_NEAR(quality.largest_sum, 1, 1e-5);
    for (const PatchPoint& point : map.points) EXPECT_TRUE(std::isfinite(point.uv.x) && std::isfinite(point.uv.y));
  }
}

TEST(Patches, CellsHangTogetherAndAreNotTooLarge) {
  const Mesh mesh = builtin(Builtin::plane, 20'000);
  const VertexGraph graph = make_vertex_graph(mesh);
  const Cells cells = partition(mesh, graph, {80, 1000});
  const Adjacency members = members_of(cells);
  EXPECT_GT(cells.count, 10u);
  for (std::uint32_t c = 0; c < cells.count; ++c) {
    ASSERT_FALSE(members.of(c).empty());
    EXPECT_LE(members.of(c).size(), 1000u);
    std::vector<std::uint32_t> reached = {members.of(c).front()};
    std::set<std::uint32_t> seen(reached.begin(), reached.end());
    for (std::size_t i = 0; i < reached.size(); ++i) {
      for (const std::uint32_t next : graph.neighbours.of(reached[i])) {
        if (cells.cell[next] == c && seen.insert(next).second) reached.push_back(next);
      }
    }
    EXPECT_EQ(reached.size(), members.of(c).size());
  }
}

TEST(Patches, HardBordersKeepTheLargestShare) {
  const Mesh mesh = builtin(Builtin::creature, 5000);
  const PatchMap map = lay_patches(mesh), hard = with_hard_borders(map);
  ASSERT_EQ(hard.patch_triangles.size(), mesh.triangles.size());
  const auto share = [&](const PatchTriangle& patch_triangle) {
    return map.points[patch_triangle.points.x].weight + map.points[patch_triangle.points.y].weight +
           map.points[patch_triangle.points.z].weight;
  };
  for (const PatchTriangle& patch_triangle : map.patch_triangles)
    EXPECT_LE(share(patch_triangle), share(hard.patch_triangles[patch_triangle.triangle]));
  EXPECT_TRUE(std::all_of(hard.points.begin(), hard.points.end(), [](const PatchPoint& p) { return p.weight == 1; }));
}

/// Two squares of side 1: the first on a quarter of its texture, the second mirrored on the same quarter.
RawModel two_squares_with_uvs() {
  RawModel raw =
      shapes::model_of({{0, 0, 0}, {1, 0, 0}, {1, 0, -1}, {0, 0, -1}, {2, 0, 0}, {3, 0, 0}, {3, 0, -1}, {2, 0, -1}},
                       {{0, 1, 2}, {0, 2, 3}, {4, 5, 6}, {4, 6, 7}});
  const glm::dvec2 a(0, 0), b(0.5, 0), c(0.5, 0.5), d(0, 0.5);
  raw.corner_uv = {a, b, c, a, c, d, b, a, d, b, d, c};
  return raw;
}

TEST(OwnUvs, KeepLengthsAndTurnMirroredIslandsOver) {
  const Result<Mesh> mesh = shapes::prepared(two_squares_with_uvs());
  ASSERT_TRUE(mesh.ok());
  const Result<PatchMap> map = own_uv_patches(*mesh);
  ASSERT_TRUE(map.ok()) << map.status().message;
  EXPECT_EQ(map->patches, 2u);
  EXPECT_EQ(map->patch_triangles.size(), 4u);
  EXPECT_EQ(map->points.size(), 8u);
  for (const PatchTriangle& patch_triangle : map->patch_triangles) {
    const Stretch stretch = stretch_of(*mesh, *map, patch_triangle);
    EXPECT_NEAR(stretch.large, 1, 1e-5);
    EXPECT_NEAR(stretch.small, 1, 1e-5);
    EXPECT_FALSE(stretch.flipped);
  }
}

TEST(OwnUvs, AreRefusedWhereThereAreNone) {
  const Result<Mesh> bare = shapes::prepared(shapes::cube());
  EXPECT_EQ(own_uv_patches(*bare).status().code, Code::invalid);
  RawModel point = two_squares_with_uvs();
  for (glm::dvec2& uv : point.corner_uv) uv = glm::dvec2(0.5);
  EXPECT_EQ(own_uv_patches(*shapes::prepared(point)).status().code, Code::invalid);
}

TEST(ValueNoise, IsSmoothWithinItsRangeAndDependsOnTheSeed) {
  double low = 1, high = -1;
  for (int i = -2000; i < 2000; ++i) {
    const glm::dvec3 position = 0.013 * i * glm::dvec3(1, 0.7, -0.3);
    const double here = value_noise(position, 1);
    low = std::min(low, here), high = std::max(high, here);
    EXPECT_LT(std::abs(value_noise(position + glm::dvec3(1e-4), 1) - here), 2e-3);
  }
  EXPECT_GE(low, -1);
  EXPECT_LE(high, 1);
  EXPECT_LT(low, -0.5);
  EXPECT_GT(high, 0.5);
  EXPECT_NE(value_noise({0.5, 0.5, 0.5}, 1), value_noise({0.5, 0.5, 0.5}, 2));
}

TEST(SharedPatches, CoverTheModelsOfTheSharedFolder) {
  if (shared_models::folder().empty()) {
    const char* ci = std::getenv("CI");
    if (ci && std::string(ci) == "true") FAIL() << "shared/meshes is missing";
    GTEST_SKIP() << "shared/meshes is missing";
  }
  for (const char* file : {"spot.obj", "cat.obj", "koala_low.obj", "goathead.obj", "penguin.obj"}) {
    SCOPED_TRACE(file);
    const Result<Mesh> mesh = shared_models::load_file(shared_models::folder() + "/" + file);
    ASSERT_TRUE(mesh.ok());
    expect_good(*mesh, lay_patches(*mesh), 1.3);
  }
  const Result<Mesh> spot = shared_models::load_file(shared_models::folder() + "/spot.obj");
  const Result<PatchMap> own = own_uv_patches(*spot);
  ASSERT_TRUE(own.ok()) << own.status().message;
  EXPECT_EQ(own.value().patch_triangles.size(), spot->triangles.size());
  const Quality quality = quality_of(*spot, own.value());
  EXPECT_LT(quality.flipped, 0.001);
  EXPECT_EQ(quality.min_sum, 1);
  EXPECT_LT(own.value().patches, 40u);
  std::cout << "spot.obj: its own map has " << own.value().patches << " islands, " << 100 * quality.stretched
            << "% stretched by over 1.4\n";
}

}  // namespace
}  // namespace pelage::patches_test
