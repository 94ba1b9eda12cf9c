#include "server/groom/first_groom.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <map>
#include <tuple>

#include "server/builtin/builtin.h"
#include "server/fields/field_set.h"
#include "server/groom/fur_flow.h"
#include "server/surface/geodesics.h"
#include "server/surface/prepare.h"
#include "tests/unit/surface/shapes.h"

namespace pelage {
namespace {

/// Unit directions of the flow in space, and the lengths of its vectors.
struct Flow {
  std::vector<glm::dvec3> directions;
  std::vector<double> lengths;
};

Flow flow_of(const Mesh& mesh) {
  Flow flow;
  const std::vector<glm::dvec2> vectors = fur_flow(mesh);
  for (std::size_t v = 0; v < vectors.size(); ++v) {
    const glm::dvec3 normal(mesh.normals[v]), tangent(mesh.tangents[v]);
    const glm::dvec3 vector = vectors[v].x * tangent + vectors[v].y * glm::cross(normal, tangent);
    flow.lengths.push_back(glm::length(vector));
    flow.directions.push_back(vector / std::max(glm::length(vector), 1e-12));
  }
  return flow;
}

/// Index of the flow in a triangle: turns of the direction around it, less the turn by parallel transport. 1 at a
/// source, sink or whorl, -1 at a saddle.
int index_of(const Mesh& mesh, const Flow& flow, const glm::uvec3& t) {
  double turned = 0;
  glm::dvec3 along_edges(1, 0, 0);
  for (int k = 0; k < 3; ++k) {
    const std::uint32_t a = t[k], b = t[(k + 1) % 3];
    const glm::dvec3 from(mesh.normals[a]), to(mesh.normals[b]);
    const auto angle = [](glm::dvec3 u, glm::dvec3 v, glm::dvec3 axis) {
      return std::atan2(glm::dot(glm::cross(u, v), axis), glm::dot(u, v));
    };
    turned += angle(transported(flow.directions[a], from, to), flow.directions[b], to);
    if (k == 0) along_edges = flow.directions[a];
    along_edges = transported(along_edges, from, to);
    if (k == 2) turned += angle(flow.directions[t.x], along_edges, to);
  }
  return static_cast<int>(std::lround(turned / 6.283185307179586));
}

struct Singular {
  int sources = 0, saddles = 0;
};

Singular count_singular(const Mesh& mesh) {
  const Flow flow = flow_of(mesh);
  Singular count;
  for (const glm::uvec3& t : mesh.triangles) {
    const int index = index_of(mesh, flow, t);
    // Fur stands up at singularities, since lying strands would form a whorl there.
    for (int k = 0; index != 0 && k < 3; ++k) EXPECT_LT(flow.lengths[t[k]], 0.5);
    count.sources += index > 0 ? 1 : 0, count.saddles += index < 0 ? 1 : 0;
  }
  return count;
}

Mesh builtin(Builtin shape, int triangles) { return prepare(make_builtin({shape, triangles})).value(); }

TEST(FurFlow, HasTwoSourcesOnABallAndNoneOnATorus) {
  const Singular ball = count_singular(builtin(Builtin::sphere, 8000));
  EXPECT_EQ(ball.sources, 2);
  EXPECT_EQ(ball.saddles, 0);
  const Singular torus = count_singular(builtin(Builtin::torus, 3000));
  EXPECT_EQ(torus.sources, 0);
  EXPECT_EQ(torus.saddles, 0);
}

// Above some size the flow is solved approximately.
TEST(FurFlow, HasTwoSourcesOnALargeBall) {
  const Mesh mesh = builtin(Builtin::sphere, 130'000);
  ASSERT_GT(mesh.positions.size(), 60'000u);
  const Singular ball = count_singular(mesh);
  EXPECT_EQ(ball.sources, 2);
  EXPECT_EQ(ball.saddles, 0);
}

/// How often fur_flow polls its cancel; it does so at steps of about equal work.
std::size_t steps_of(const RawModel& raw) {
  std::size_t steps = 0;
  const Cancel counting([&steps] { return ++steps, false; });
  fur_flow(prepare(raw).value(), counting);
  return steps;
}

RawModel spiky_polygon(std::uint32_t corners) {
  RawModel raw;
  raw.face_sizes = {corners};
  for (std::uint32_t i = 0; i < corners; ++i) {
    const double angle = 6.283185307179586 * i / corners, radius = i % 2 == 0 ? 1 : 0.5;
    raw.positions.emplace_back(radius * std::cos(angle), radius * std::sin(angle), 0);
    raw.corners.push_back(i);
  }
  return raw;
}

RawModel many_balls(std::uint32_t count) {
  RawModel raw;
  const RawModel ball = shapes::ball(4);
  for (std::uint32_t i = 0; i < count; ++i) {
    const auto first = static_cast<std::uint32_t>(raw.positions.size());
    for (const glm::dvec3& p : ball.positions) raw.positions.push_back(p + glm::dvec3(3 * (i % 100), 3 * (i / 100), 0));
    for (const std::uint32_t v : ball.corners) raw.corners.push_back(first + v);
    raw.face_sizes.insert(raw.face_sizes.end(), ball.face_sizes.begin(), ball.face_sizes.end());
  }
  return raw;
}

// Every spike is an end of the flow, and every ball has one.
TEST(FurFlow, StepsDoNotGrowWithTheNumberOfEnds) {
  EXPECT_LT(steps_of(spiky_polygon(20'000)), 20u);
  EXPECT_LT(steps_of(many_balls(2'000)), 100u);
}

TEST(FurFlow, EndsOnceNobodyWaits) {
  const Mesh mesh = prepare(spiky_polygon(20'000)).value();
  EXPECT_THROW(fur_flow(mesh, Cancel([] { return true; })), Cancelled);
}

// Sources under the chin and at the end of each limb, each ear and the tail, and as many saddles as the shape then
// needs.
TEST(FurFlow, OfAnAnimalBeginsUnderTheChinAndEndsAtItsLimbs) {
  const Singular animal = count_singular(builtin(Builtin::creature, 8000));
  EXPECT_EQ(animal.sources - animal.saddles, 2);
  EXPECT_LE(animal.sources, 10);
  EXPECT_GE(animal.sources, 6);
}

/// A ball that is mirror-symmetric, triangle by triangle: the right half and its mirror image.
RawModel symmetric_ball(int rings) {
  RawModel ball = shapes::ball(rings);
  RawModel half = ball;
  half.face_sizes.clear(), half.corners.clear();
  std::map<std::tuple<long, long, long>, std::uint32_t> vertex_at;
  const auto key = [](glm::dvec3 p) {
    return std::tuple(std::lround(p.x * 1e6), std::lround(p.y * 1e6), std::lround(p.z * 1e6));
  };
  for (std::uint32_t v = 0; v < ball.positions.size(); ++v) vertex_at[key(ball.positions[v])] = v;
  const auto mirror = [&](std::uint32_t v) { return vertex_at.at(key(ball.positions[v] * glm::dvec3(-1, 1, 1))); };
  for (std::size_t i = 0; i < ball.corners.size(); i += 3) {
    const std::array<std::uint32_t, 3> t{ball.corners[i], ball.corners[i + 1], ball.corners[i + 2]};
    if (ball.positions[t[0]].x + ball.positions[t[1]].x + ball.positions[t[2]].x < 0) continue;
    half.face_sizes.insert(half.face_sizes.end(), {3, 3});
    half.corners.insert(half.corners.end(), {t[0], t[1], t[2], mirror(t[0]), mirror(t[2]), mirror(t[1])});
  }
  return half;
}

/// A symmetric body with a snout, two ears and a tail.
Mesh toy() {
  RawModel raw = symmetric_ball(40);
  for (glm::dvec3& p : raw.positions) {
    const auto bump = [&](glm::dvec3 at, double size) { return std::exp(-glm::dot(p - at, p - at) / (size * size)); };
    const glm::dvec3 ear(std::abs(p.x) < 0.01 ? 0 : 0.5 * p.x / std::abs(p.x), 0.75, 0.4);
    const double ears = bump(ear, 0.2), snout = bump({0, 0, 1}, 0.4), tail = bump({0, 0.2, -1}, 0.25);
    p += glm::dvec3(0, 0.9 * ears, 0.6 * snout - 1.2 * tail);
  }
  return prepare(raw).value();
}

TEST(FurFlow, IsSymmetricOnASymmetricModel) {
  const Mesh mesh = toy();
  const Flow flow = flow_of(mesh);
  std::map<std::tuple<long, long, long>, std::size_t> vertex_at;
  const auto key = [](glm::vec3 p) {
    const auto rounded = [](float x) { return std::lround(x * 1e4f); };
    return std::tuple(rounded(p.x), rounded(p.y), rounded(p.z));
  };
  for (std::size_t v = 0; v < mesh.positions.size(); ++v) vertex_at[key(mesh.positions[v])] = v;
  std::size_t pairs = 0, alike = 0;
  for (std::size_t v = 0; v < mesh.positions.size(); ++v) {
    const glm::vec3 p = mesh.positions[v];
    const auto other = vertex_at.find(key({-p.x, p.y, p.z}));
    if (other == vertex_at.end()) continue;
    const glm::dvec3 vector = flow.directions[v] * flow.lengths[v];
    const glm::dvec3 mirrored = flow.directions[other->second] * flow.lengths[other->second] * glm::dvec3(-1, 1, 1);
    ++pairs, alike += glm::distance(vector, mirrored) < 0.15 ? 1 : 0;
  }
  EXPECT_GT(pairs, mesh.positions.size() * 9 / 10);
  EXPECT_GT(alike, pairs * 97 / 100);
}

TEST(FurFlow, GoesFromNoseToTailOnAPlane) {
  const Flow flow = flow_of(builtin(Builtin::plane, 200));
  for (const glm::dvec3& direction : flow.directions) EXPECT_LT(std::min(direction.z, direction.y), -0.3);
}

TEST(FirstGroom, HasTheAskedInclinationAndLength) {
  Mesh mesh = builtin(Builtin::torus, 3000);
  mesh.length_scale.resize(mesh.positions.size());
  for (std::size_t v = 0; v < mesh.length_scale.size(); ++v) mesh.length_scale[v] = v % 2 == 0 ? 0.5f : 2.0f;
  const FieldSet fields = first_groom(mesh, {.length = 0.04, .inclination = 0.6});
  std::size_t leaning = 0;
  for (std::uint32_t v = 0; v < fields.size(); ++v) {
    EXPECT_NEAR(fields.length()[v], v % 2 == 0 ? 0.02 : 0.08, 1e-6);
    EXPECT_EQ(fields.at(v).stretch, 0);
    EXPECT_LE(glm::length(fields.direction()[v]), 0.6f + 1e-5f);
    leaning += glm::length(fields.direction()[v]) > 0.3f ? 1 : 0;
  }
  EXPECT_GT(leaning, fields.size() * 3 / 5);
}

// No strand grows into a face at an edge, however far it is asked to lean.
TEST(FirstGroom, RisesFromAllSidesOfAnEdge) {
  RawModel cube;
  for (int i = 0; i < 8; ++i) cube.positions.emplace_back(i & 1, (i >> 1) & 1, i >> 2);
  for (const auto& face :
       {std::array{0, 2, 3, 1}, {4, 5, 7, 6}, {0, 1, 5, 4}, {2, 6, 7, 3}, {0, 4, 6, 2}, {1, 3, 7, 5}}) {
    cube.face_sizes.push_back(4);
    for (const int v : face) cube.corners.push_back(static_cast<std::uint32_t>(v));
  }
  const Mesh mesh = prepare(cube).value();
  const FieldSet fields = first_groom(mesh, {.inclination = 1});
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
    for (std::size_t k = 0; k < 3; ++k) {
      const std::uint32_t v = mesh.triangles[t][static_cast<int>(k)];
      const glm::vec2 direction = fields.direction()[v];
      const float angle = glm::length(direction) * 1.5707963f;
      const glm::vec3 lean =
          direction.x * mesh.tangents[v] + direction.y * glm::cross(mesh.normals[v], mesh.tangents[v]);
      const glm::vec3 strand =
          std::cos(angle) * mesh.normals[v] + std::sin(angle) * lean / std::max(glm::length(lean), 1e-6f);
      EXPECT_GT(glm::dot(strand, mesh.shading_normals[t][k]), 0.25f);
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
