#include "server/builtin/builtin.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <map>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "server/builtin/builtin_cache.h"
#include "server/builtin/creature.h"
#include "server/builtin/implicit.h"
#include "server/builtin/remesh.h"

namespace pelage::builtin_test {
namespace {

using glm::dvec3;

struct Triangle {
  dvec3 a, b, c;
  dvec3 area_vector() const { return 0.5 * glm::cross(b - a, c - a); }
};

std::size_t triangle_count(const RawModel& model) { return model.face_sizes.size(); }

Triangle triangle(const RawModel& model, std::size_t t) {
  const auto corner = [&](std::size_t k) { return model.positions[model.corners[3 * t + k]]; };
  return {corner(0), corner(1), corner(2)};
}

/// Counts how often each directed edge occurs.
std::map<std::pair<std::uint32_t, std::uint32_t>, int> directed_edges(const RawModel& model) {
  std::map<std::pair<std::uint32_t, std::uint32_t>, int> edges;
  for (std::size_t t = 0; t < triangle_count(model); ++t)
    for (std::size_t k = 0; k < 3; ++k) ++edges[{model.corners[3 * t + k], model.corners[3 * t + (k + 1) % 3]}];
  return edges;
}

/// Number of edge-connected fans of triangles around vertices; one for each vertex of a manifold.
std::size_t fan_count(const RawModel& model) {
  std::map<std::pair<std::uint32_t, std::uint32_t>, std::uint32_t> after;  // (hub, rim vertex) -> next rim vertex
  for (std::size_t t = 0; t < triangle_count(model); ++t)
    for (std::size_t k = 0; k < 3; ++k)
      after[{model.corners[3 * t + k], model.corners[3 * t + (k + 1) % 3]}] = model.corners[3 * t + (k + 2) % 3];
  std::size_t fans = 0;
  while (!after.empty()) {
    auto at = after.begin();
    const std::uint32_t hub = at->first.first;
    while (at != after.end()) {
      const std::uint32_t rim = at->second;
      after.erase(at);
      at = after.find({hub, rim});
    }
    ++fans;
  }
  return fans;
}

void expect_closed_manifold(const RawModel& model, int euler) {
  const auto edges = directed_edges(model);
  for (const auto& [edge, count] : edges) {
    ASSERT_NE(edge.first, edge.second);
    ASSERT_EQ(count, 1) << "edge " << edge.first << "-" << edge.second << " used twice in one direction";
    ASSERT_TRUE(edges.contains({edge.second, edge.first})) << "edge " << edge.first << "-" << edge.second << " is open";
  }
  EXPECT_EQ(fan_count(model), model.positions.size());
  const auto vertices = static_cast<long>(model.positions.size()), faces = static_cast<long>(triangle_count(model));
  EXPECT_EQ(vertices - static_cast<long>(edges.size() / 2) + faces, euler);
}

void expect_sound_triangles(const RawModel& model) {
  ASSERT_EQ(model.corners.size(), 3 * model.face_sizes.size());
  ASSERT_TRUE(std::all_of(model.face_sizes.begin(), model.face_sizes.end(), [](auto size) { return size == 3; }));
  for (const std::uint32_t corner : model.corners) ASSERT_LT(corner, model.positions.size());
  for (std::size_t t = 0; t < triangle_count(model); ++t) {
    const Triangle it = triangle(model, t);
    const double longest = std::max({glm::distance(it.a, it.b), glm::distance(it.b, it.c), glm::distance(it.c, it.a)});
    ASSERT_GT(glm::length(it.area_vector()), 0.01 * longest * longest) << "triangle " << t;
  }
}

double signed_volume(const RawModel& model) {
  double six_volumes = 0;
  for (std::size_t t = 0; t < triangle_count(model); ++t) {
    const Triangle it = triangle(model, t);
    six_volumes += glm::dot(it.a, glm::cross(it.b, it.c));
  }
  return six_volumes / 6;
}

std::pair<dvec3, dvec3> box(const RawModel& model) {
  dvec3 low(std::numeric_limits<double>::max()), high(-std::numeric_limits<double>::max());
  for (const dvec3& p : model.positions) low = glm::min(low, p), high = glm::max(high, p);
  return {low, high};
}

struct Closed {
  Builtin shape;
  int euler;
  double min_volume;
  const char* name;
};

class ClosedBuiltin : public testing::TestWithParam<Closed> {
 protected:
  static void expect_closed(int wished) {
    SCOPED_TRACE(wished);
    const RawModel model = make_builtin({GetParam().shape, wished});
    expect_sound_triangles(model);
    expect_closed_manifold(model, GetParam().euler);
    EXPECT_GT(signed_volume(model), GetParam().min_volume);
    EXPECT_NEAR(static_cast<double>(triangle_count(model)), wished, 0.2 * wished);
  }
};

TEST_P(ClosedBuiltin, IsAClosedManifoldWoundOutwardsWithAboutTheWishedCount) {
  for (const int wished : {500, 5000}) expect_closed(wished);
}

TEST_P(ClosedBuiltin, StaysClosedAtManyTriangles) { expect_closed(50000); }

TEST_P(ClosedBuiltin, StaysClosedAtTheFewestTriangles) {
  for (const int wished : {2, 19, 100}) {
    SCOPED_TRACE(wished);
    const RawModel model = make_builtin({GetParam().shape, wished});
    expect_closed_manifold(model, GetParam().euler);
    EXPECT_GT(signed_volume(model), 0);
    EXPECT_LE(triangle_count(model), 500u);
  }
}

INSTANTIATE_TEST_SUITE_P(Shapes, ClosedBuiltin,
                         testing::Values(Closed{Builtin::torus, 0, 2.5, "torus"}, Closed{Builtin::knot, 0, 1.3, "knot"},
                                         Closed{Builtin::sphere, 2, 4.0, "sphere"},
                                         Closed{Builtin::creature, 2, 0.12, "creature"}),
                         [](const auto& param_info) { return std::string(param_info.param.name); });

TEST(Builtin, PlaneAndClothAreSheetsWithAboutTheWishedCount) {
  for (const Builtin shape : {Builtin::plane, Builtin::cloth})
    for (const int wished : {500, 5000, 50000}) {
      const RawModel model = make_builtin({shape, wished});
      expect_sound_triangles(model);
      EXPECT_NEAR(static_cast<double>(triangle_count(model)), wished, 0.2 * wished);
      for (const auto& [edge, count] : directed_edges(model)) ASSERT_EQ(count, 1);
      double upwards = 0;
      for (std::size_t t = 0; t < triangle_count(model); ++t) upwards += triangle(model, t).area_vector().y;
      EXPECT_GT(upwards, 0.9);
    }
}

TEST(Builtin, PlaneOfTwoTrianglesIsPossible) { EXPECT_EQ(triangle_count(make_builtin({Builtin::plane, 2})), 2u); }

TEST(Builtin, SphereIsRoundAndEven) {
  const RawModel model = make_builtin({Builtin::sphere, 5000});
  for (const dvec3& p : model.positions) ASSERT_NEAR(glm::length(p), 1, 1e-12);
  double min = 1e9, max = 0;
  for (std::size_t t = 0; t < triangle_count(model); ++t) {
    const double area = glm::length(triangle(model, t).area_vector());
    min = std::min(min, area), max = std::max(max, area);
  }
  EXPECT_LT(max / min, 1.5);
}

TEST(Builtin, OnlyTheCreatureHasALookOfItsOwn) {
  for (const Builtin shape : {Builtin::torus, Builtin::knot, Builtin::sphere, Builtin::plane, Builtin::cloth}) {
    const RawModel model = make_builtin({shape, 500});
    EXPECT_TRUE(model.corner_colour.empty());
    EXPECT_TRUE(model.length_scale.empty());
  }
}

/// Made once, since that takes a second.
const RawModel& creature_of_5000() {
  static const RawModel made = make_builtin({Builtin::creature, 5000});
  return made;
}

TEST(BuiltinCache, IsWhatWasAskedForAndIsMadeOnce) {
  BuiltinCache cache;
  auto coarse = cache.model({Builtin::creature, 1000});
  EXPECT_EQ(cache.model({Builtin::creature, 1000}), coarse);
  const std::size_t few = triangle_count(*coarse);
  const std::weak_ptr<const RawModel> cached = std::exchange(coarse, nullptr);
  EXPECT_FALSE(cached.expired());
  const auto fine = cache.model({Builtin::creature, 5000});
  EXPECT_TRUE(cached.expired()) << "only the last one is cached";
  EXPECT_LT(few, triangle_count(*fine));
  EXPECT_EQ(fine->positions, creature_of_5000().positions);
  EXPECT_EQ(triangle_count(*cache.model({Builtin::plane, 2})), 2u);
}

TEST(Creature, IsTheSameEachTime) {
  const RawModel &one = creature_of_5000(), other = make_builtin({Builtin::creature, 5000});
  EXPECT_EQ(one.positions, other.positions);
  EXPECT_EQ(one.corners, other.corners);
  EXPECT_EQ(one.corner_colour, other.corner_colour);
  EXPECT_EQ(one.length_scale, other.length_scale);
}

TEST(Creature, IsLongerThanHighThanWide) {
  const auto [low, high] = box(creature_of_5000());
  const dvec3 size = high - low;
  EXPECT_GT(size.z, 1.1 * size.y);
  EXPECT_GT(size.y, 2 * size.x);
  EXPECT_NEAR(low.x, -high.x, 0.02);
}

TEST(Creature, HasFourPawsTwoEarsANoseInFrontAndATailBehind) {
  const RawModel& model = creature_of_5000();
  const auto [low, high] = box(model);
  bool paw[2][2] = {}, ear[2] = {};
  dvec3 front = model.positions[0], behind = model.positions[0];
  for (const dvec3& p : model.positions) {
    if (p.y < low.y + 0.06) {
      EXPECT_GT(std::abs(p.x), 0.03) << "nothing but paws touches the ground";
      paw[p.x > 0][p.z > 0] = true;
    }
    if (p.y > high.y - 0.08) {
      EXPECT_GT(std::abs(p.x), 0.1) << "the ears stand apart";
      ear[p.x > 0] = true;
    }
    if (p.z > front.z) front = p;
    if (p.z < behind.z) behind = p;
  }
  EXPECT_TRUE(paw[0][0] && paw[0][1] && paw[1][0] && paw[1][1]);
  EXPECT_TRUE(ear[0] && ear[1]);
  EXPECT_NEAR(front.x, 0, 0.05);
  EXPECT_NEAR(glm::distance(front, creature::kNose), 0, 0.07);
  EXPECT_NEAR(behind.x, 0, 0.1);
  EXPECT_GT(behind.y, 0.4);
}

TEST(Creature, EdgesAreEvenAndVerticesLieOnTheSurface) {
  const RawModel& model = creature_of_5000();
  double sum = 0, max = 0;
  const auto edges = directed_edges(model);
  for (const auto& [edge, count] : edges) {
    const double length = glm::distance(model.positions[edge.first], model.positions[edge.second]);
    sum += length, max = std::max(max, length);
  }
  EXPECT_LT(max, 2 * sum / static_cast<double>(edges.size()));
  const ImplicitSurface surface(creature_volumes());
  for (const dvec3& p : model.positions) ASSERT_LT(std::abs(surface.sample(p).distance), 1e-4);
}

TEST(Creature, ColoursAndLengthsAreInRangeAndOnePerCornerAndPosition) {
  const RawModel& model = creature_of_5000();
  ASSERT_EQ(model.corner_colour.size(), model.corners.size());
  ASSERT_EQ(model.length_scale.size(), model.positions.size());
  for (const glm::vec4& c : model.corner_colour) {
    for (int k = 0; k < 3; ++k) ASSERT_TRUE(c[k] >= 0 && c[k] <= 1);
    ASSERT_EQ(c.a, 1);
  }
  for (const float scale : model.length_scale) ASSERT_TRUE(scale > 0 && scale <= 4);
}

TEST(Creature, IsPaintedLikeAFox) {
  const auto colour = [](dvec3 p) { return creature_look(p).colour; };
  const auto bright = [&](dvec3 p) { return (colour(p).r + colour(p).g + colour(p).b) / 3; };
  const dvec3 flank{.15, .52, -.05}, chest{0, .52, .39};
  EXPECT_GT(colour(flank).r, 2 * colour(flank).g) << "a red-brown flank";
  EXPECT_GT(colour(flank).g, 2 * colour(flank).b);
  EXPECT_GT(bright(chest), 0.5);
  EXPECT_GT(bright(creature::kTailTip), 0.5);
  EXPECT_LT(bright(creature::kForepaw), 0.06);
  EXPECT_LT(bright(creature::kHindPaw), 0.06);
  EXPECT_LT(bright(creature::kNose), 0.03);
  EXPECT_LT(bright(creature::kEarTip), 0.06);
  EXPECT_LT(bright(creature::kEye), 0.06);
}

TEST(Creature, FurIsShortOnTheFaceAndLongOnTheTail) {
  const auto scale = [](dvec3 p) { return creature_look(p).length_scale; };
  EXPECT_NEAR(scale({.15, .52, -.05}), 1, 0.01);
  EXPECT_NEAR(scale(creature::kNose), .1, 0.01);
  EXPECT_NEAR(scale(creature::kEye), .1, 0.01);
  EXPECT_NEAR(scale(creature::kForepaw), .4, 0.01);
  EXPECT_NEAR(scale({0, .55, .38}), 1.4, 0.05);
  EXPECT_NEAR(scale({0, .64, -.73}), 1.8, 0.01);
}

TEST(Creature, LookVariesSmoothly) {
  const RawModel& model = creature_of_5000();
  constexpr double kStep = 1e-5, kSteepest = 120;  // in full ranges per unit of length
  for (const dvec3& p : model.positions)
    for (int axis = 0; axis < 3; ++axis) {
      dvec3 q = p;
      q[axis] += kStep;
      const CreatureLook here = creature_look(p), there = creature_look(q);
      ASSERT_LT(glm::length(here.colour - there.colour), kSteepest * kStep);
      ASSERT_LT(std::abs(here.length_scale - there.length_scale), kSteepest * kStep);
    }
}

TEST(Implicit, GradientIsAboutTheSlopeOfTheDistance) {
  const ImplicitSurface surface(creature_volumes());
  const std::vector<dvec3>& positions = creature_of_5000().positions;
  constexpr double kStep = 1e-6;
  for (std::size_t i = 0; i < positions.size(); i += 5) {
    const dvec3 p = positions[i], gradient = surface.sample(p).gradient;
    for (int axis = 0; axis < 3; ++axis) {
      dvec3 low = p, high = p;
      low[axis] -= kStep, high[axis] += kStep;
      const double slope = (surface.sample(high).distance - surface.sample(low).distance) / (2 * kStep);
      ASSERT_NEAR(slope, gradient[axis], 0.1);
    }
  }
}

TEST(Implicit, PolygonisedBallIsClosedAndOutwards) {
  const ImplicitSurface ball({{{RoundCone{}}}});
  const TriangleMesh mesh = remesh(ball, polygonise(ball, 0.1), 2000);
  double six_volumes = 0;
  for (const glm::uvec3& t : mesh.triangles)
    six_volumes += glm::dot(mesh.positions[t.x], glm::cross(mesh.positions[t.y], mesh.positions[t.z]));
  EXPECT_NEAR(six_volumes / 6, 4.18879, 0.03);
  EXPECT_NEAR(static_cast<double>(mesh.triangles.size()), 2000, 100);
  for (const dvec3& p : mesh.positions) ASSERT_NEAR(glm::length(p), 1, 1e-6);
}

TriangleMesh triangles_of(const RawModel& model) {
  TriangleMesh mesh{model.positions, {}};
  for (std::size_t k = 0; k < model.corners.size(); k += 3)
    mesh.triangles.emplace_back(model.corners[k], model.corners[k + 1], model.corners[k + 2]);
  return mesh;
}

TEST(HalfEdgeMesh, RefusesToPinchATube) {
  // 10 rings of 3 vertices; vertices of a ring differ by multiples of 10.
  const HalfEdgeMesh mesh(triangles_of(make_builtin({Builtin::torus, 60})));
  ASSERT_EQ(mesh.vertex_count(), 30u);
  int allowed = 0;
  for (std::uint32_t h = 0; h < mesh.half_edge_count(); ++h) {
    const bool in_a_ring = mesh.origin(h) % 10 == mesh.target(h) % 10;
    EXPECT_FALSE(in_a_ring && mesh.can_collapse(h)) << "half-edge " << h;
    allowed += mesh.can_collapse(h) ? 1 : 0;
  }
  EXPECT_GT(allowed, 0);
}

TEST(HalfEdgeMesh, SplitFlipAndCollapseKeepTwinsAndFans) {
  HalfEdgeMesh mesh(triangles_of(make_builtin({Builtin::sphere, 80})));
  mesh.split(7, dvec3(0, 0, 1));
  ASSERT_TRUE(mesh.can_flip(31));
  mesh.flip(31);
  ASSERT_TRUE(mesh.can_collapse(100));
  mesh.collapse(100, dvec3(0, 1, 0));
  EXPECT_EQ(mesh.live_triangles(), 80u);
  for (std::uint32_t h = 0; h < mesh.half_edge_count(); ++h) {
    if (!mesh.live(h)) continue;
    EXPECT_EQ(mesh.twin(mesh.twin(h)), h);
    EXPECT_EQ(mesh.target(mesh.twin(h)), mesh.origin(h));
    EXPECT_EQ(mesh.origin(mesh.twin(h)), mesh.target(h));
    bool seen = false;
    mesh.around(mesh.origin(h), [&](std::uint32_t spoke) { seen = seen || spoke == h; });
    EXPECT_TRUE(seen);
  }
}

TEST(Decimate, KeepsTheGenus) {
  const TriangleMesh mesh = decimate(triangles_of(make_builtin({Builtin::torus, 5000})), 200);
  EXPECT_EQ(mesh.triangles.size(), 200u);
  EXPECT_EQ(mesh.positions.size(), 100u);  // a torus has half as many vertices as triangles
}

}  // namespace
}  // namespace pelage::builtin_test
