// Searches on a surface, against plain ones that follow the definition.
#include <gtest/gtest.h>

#include <cmath>
#include <queue>

#include "base/random.h"
#include "server/builtin/builtin.h"
#include "server/surface/adjacency.h"
#include "server/surface/geodesics.h"
#include "server/surface/prepare.h"
#include "server/surface/value_noise.h"

namespace pelage::spread_test {
namespace {

TEST(MonotoneQueueTest, GivesWhatABinaryHeapGives) {
  using Entry = MonotoneQueue::Entry;
  for (std::uint64_t seed = 1; seed <= 20; ++seed) {
    Random random(seed);
    const double reach = random.uniform(0.1, 3);
    MonotoneQueue queue(random.uniform(0.01, 1), reach);
    std::priority_queue<Entry, std::vector<Entry>, std::greater<>> heap;
    double last = random.uniform(0, 100);
    const auto push = [&] {
      // Coarse distances, so that many are equal.
      const double distance = last + std::floor(random.uniform(0, 8)) / 8 * reach;
      const auto vertex = static_cast<std::uint32_t>(random.uniform(0, 50));
      queue.push(distance, vertex), heap.emplace(distance, vertex);
    };
    push();
    for (int i = 0; !heap.empty(); ++i) {
      ASSERT_FALSE(queue.empty());
      ASSERT_EQ(queue.min(), heap.top().first);
      ASSERT_EQ(queue.pop(), heap.top());
      last = heap.top().first;
      heap.pop();
      for (int k = 0; i < 500 && k < 3; ++k) push();
      if (heap.empty() && i < 400) last += 1000 * reach, push();  // an empty queue may restart at any distance
    }
    EXPECT_TRUE(queue.empty());
  }
}

/// Shortest paths by repeated relaxation over neighbours until nothing changes (Bellman and Ford).
std::vector<double> plain_distances(const Mesh& mesh, std::span<const SpreadSource> sources) {
  std::vector<double> distances(mesh.positions.size(), std::numeric_limits<double>::infinity());
  for (const SpreadSource& source : sources)
    distances[source.vertex] = std::min(distances[source.vertex], source.distance);
  for (bool changed = true; changed;) {
    changed = false;
    for (const glm::uvec3& t : mesh.triangles) {
      for (int k = 0; k < 6; ++k) {
        const std::uint32_t a = t[k % 3], b = t[(k % 3 + 1 + k / 3) % 3];
        const double length =
            distances[a] + glm::distance(glm::dvec3(mesh.positions[a]), glm::dvec3(mesh.positions[b]));
        if (length < distances[b]) distances[b] = length, changed = true;
      }
    }
  }
  return distances;
}

TEST(EdgeSearchTest, FindsTheShortestWaysToTheBit) {
  for (const Builtin shape : {Builtin::torus, Builtin::cloth, Builtin::knot}) {
    Result<Mesh> mesh = prepare(make_builtin({shape, 3000}));
    ASSERT_TRUE(mesh.ok());
    const Surface surface(std::move(*mesh));
    const auto count = static_cast<double>(surface.mesh().positions.size());
    Random random(3);
    std::vector<SpreadSource> sources;
    for (const double distance : {0.0, 0.01, 0.3, 1e6, 0.0, 0.3})  // a source far behind all others never counts
      sources.push_back({static_cast<std::uint32_t>(random.uniform(0, count)), distance, {1, 0, 0}});
    EXPECT_EQ(spread_along_edges(surface, sources).distance, plain_distances(surface.mesh(), sources));
  }
}

TEST(EdgeSearchTest, KeepsVectorsInTheSurfaceAndAsLong) {
  Result<Mesh> mesh = prepare(make_builtin({Builtin::knot, 3000}));
  ASSERT_TRUE(mesh.ok());
  const Surface surface(std::move(*mesh));
  const glm::dvec3 tangent(surface.mesh().tangents[7]);
  const Spread spread = EdgeSearch(surface)(std::vector<SpreadSource>{{7, 0, 0.5 * tangent}});
  int reached = 0;
  for (std::uint32_t v = 0; v < spread.vector.size(); ++v) {
    if (!std::isfinite(spread.distance[v])) continue;
    ++reached;
    EXPECT_NEAR(glm::length(spread.vector[v]), 0.5, 1e-4) << v;
    EXPECT_NEAR(glm::dot(spread.vector[v], glm::dvec3(surface.mesh().normals[v])), 0, 1e-4) << v;
  }
  EXPECT_GT(reached, 1000);
}

TEST(SidesTest, AreSorted) {
  const RawModel raw = make_builtin({Builtin::knot, 3000});
  const Result<Mesh> mesh = prepare(raw);
  ASSERT_TRUE(mesh.ok());
  const std::vector<Side> sides = sorted_sides(mesh->triangles);
  ASSERT_EQ(sides.size(), 3 * mesh->triangles.size());
  const auto key = [](const Side& s) { return std::array{s.low, s.high, s.triangle, s.side}; };
  for (std::size_t i = 1; i < sides.size(); ++i) ASSERT_LT(key(sides[i - 1]), key(sides[i]));
  for (const Side& side : sides) {
    const glm::uvec3& t = mesh->triangles[side.triangle];
    const std::uint32_t a = t[static_cast<int>(side.side)], b = t[static_cast<int>((side.side + 1) % 3)];
    ASSERT_EQ(std::pair(side.low, side.high), (std::pair(std::min(a, b), std::max(a, b))));
    ASSERT_EQ(side.rising, a < b);
  }
  EXPECT_TRUE(sorted_sides({}).empty());
}

/// Value noise, with the lattice values at the eight corners hashed one by one.
double plain_value_noise(glm::dvec3 position, std::uint64_t seed) {
  const glm::dvec3 low = glm::floor(position), part = position - low;
  const glm::dvec3 blend = part * part * (3.0 - 2.0 * part);
  double sum = 0;
  for (int corner = 0; corner < 8; ++corner) {
    const glm::i64vec3 step(corner & 1, (corner >> 1) & 1, corner >> 2);
    double share = 1;
    std::uint64_t bits = seed;
    for (int k = 0; k < 3; ++k) {
      share *= step[k] ? blend[k] : 1 - blend[k];
      bits = mix_bits(bits ^ static_cast<std::uint64_t>(glm::i64vec3(low)[k] + step[k]));
    }
    sum += share * (static_cast<double>(bits >> 11) * 0x1p-52 - 1);
  }
  return sum;
}

TEST(ValueNoiseTest, IsThePlainFormulaToTheBit) {
  Random random(9);
  for (std::uint64_t i = 0; i < 1000; ++i) {
    const glm::dvec3 position(random.uniform(-1e3, 1e3), random.uniform(-1, 1), random.uniform(-1e6, 1e6));
    ASSERT_EQ(value_noise(position, i), plain_value_noise(position, i));
  }
}

}  // namespace
}  // namespace pelage::spread_test
