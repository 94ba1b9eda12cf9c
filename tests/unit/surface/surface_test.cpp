#include "server/surface/surface.h"

#include <gtest/gtest.h>
#include <sys/resource.h>
#include <tbb/global_control.h>
#include <unistd.h>

#include <algorithm>
#include <cstdlib>
#include <fstream>
#include <limits>
#include <new>
#include <numeric>
#include <thread>

#include "tests/unit/surface/shapes.h"

namespace pelage::surface_test {
namespace {

Surface surface_of(const RawModel& raw) {
  Result<Mesh> mesh = shapes::prepared(raw);
  EXPECT_TRUE(mesh.ok());
  return Surface(std::move(mesh).value());
}

const double half = 0.5 / std::sqrt(3.0);  // half of the cube's side, when its diagonal is 1

TEST(Surface, RaysHitFromEitherSideAndFromFarAway) {
  const Surface cube = surface_of(shapes::cube());
  for (const double distance : {0.0, 1.0, 1e3, 1e6, 1e12}) {
    const auto hit = cube.raycast({0.1, distance, 0.05}, {0, -3, 0});
    ASSERT_TRUE(hit) << distance;
    const double expected = distance == 0 ? -half : half;  // from inside, the ray hits the far side
    EXPECT_NEAR(glm::length(cube.position(*hit) - glm::dvec3(0.1, expected, 0.05)), 0, 1e-5) << distance;
    EXPECT_NEAR(hit->barycentric.x + hit->barycentric.y + hit->barycentric.z, 1, 1e-12);
  }
}

TEST(Surface, LeavesOtherWorkItsThreads) {
  const Surface cube = surface_of(shapes::cube());
  const std::size_t allowed = tbb::global_control::active_value(tbb::global_control::max_allowed_parallelism);
  EXPECT_GE(allowed, std::thread::hardware_concurrency()) << "Embree bounds oneTBB for the whole process";
}

TEST(Surface, RaysThatMissOrAreInvalidHitNothing) {
  const Surface cube = surface_of(shapes::cube());
  const double nan = std::numeric_limits<double>::quiet_NaN();
  EXPECT_FALSE(cube.raycast({0, 1, 0}, {0, 1, 0}));
  EXPECT_FALSE(cube.raycast({5, 1, 0}, {0, -1, 0}));
  EXPECT_FALSE(cube.raycast({0, 1, 0}, {0, 0, 0}));
  EXPECT_FALSE(cube.raycast({0, nan, 0}, {0, -1, 0}));
  EXPECT_FALSE(cube.raycast({0, 1, 0}, {0, nan, 0}));
}

TEST(Surface, RaysFromFarBeyondWhatEmbreeTakesPassBy) {
  const Surface cube = surface_of(shapes::cube());
  for (const double far : {1e7, 1e19, 1e30, 1e200, std::numeric_limits<double>::max()}) {
    EXPECT_FALSE(cube.raycast({far, 0, 0}, {0, 1, 0})) << far;
    EXPECT_FALSE(cube.raycast({far, far, far}, {1, 0, 0})) << far;
    cube.raycast({0.1, far, 0.05}, {0, -1, 0});  // towards it, but too far to be exact; must not crash
  }
}

TEST(Surface, ADirectionMayHaveAnyLength) {
  const Surface cube = surface_of(shapes::cube());
  for (const double length : {1e-300, 1e-20, 1.0, 1e20, 1e300})
    EXPECT_TRUE(cube.raycast({0.1, 1, 0.05}, {0, -length, 0})) << length;
}

/// Runs out of memory in a child process: if Embree cannot allocate, Surface reports it, in release builds too.
TEST(SurfaceDeathTest, ReportsThatMemoryIsNotEnough) {
  const auto starved = [] {
    const Result<Mesh> mesh = shapes::prepared(shapes::ball(300));
    std::ifstream pages("/proc/self/statm");
    std::size_t used = 0;
    pages >> used;
    const rlim_t room = used * static_cast<std::size_t>(sysconf(_SC_PAGESIZE)) + (std::size_t{24} << 20);
    const rlimit limit{room, room};
    setrlimit(RLIMIT_AS, &limit);
    try {
      const Surface surface(*mesh);
    } catch (const std::bad_alloc&) {
      std::_Exit(0);
    }
    std::_Exit(1);
  };
  EXPECT_EXIT(starved(), testing::ExitedWithCode(0), "");
}

TEST(Surface, RaysThroughEdgesAndVerticesDoNotSlipThrough) {
  const Surface ball = surface_of(shapes::ball(12));
  for (const glm::vec3& p : ball.mesh().positions) {
    const auto hit = ball.raycast(glm::dvec3(p) * 3.0, -glm::dvec3(p));
    ASSERT_TRUE(hit);
    EXPECT_NEAR(glm::length(ball.position(*hit) - glm::dvec3(p)), 0, 1e-5);
  }
}

TEST(Surface, FindsNearestPoints) {
  const Surface cube = surface_of(shapes::cube());
  const auto at = [&](glm::dvec3 position) { return cube.position(cube.nearest(position)); };
  EXPECT_NEAR(glm::length(at({0.1, 0.9, 0.05}) - glm::dvec3(0.1, half, 0.05)), 0, 1e-6);
  EXPECT_NEAR(glm::length(at({9, 9, 9}) - glm::dvec3(half)), 0, 1e-6);
  EXPECT_NEAR(glm::length(at({0.2, 0, 0.01}) - glm::dvec3(half, 0, 0.01)), 0, 1e-6);
  EXPECT_NEAR(glm::length(at({1e30, 1e30, 1e30}) - glm::dvec3(half)), 0, 1e-6);
}

TEST(Surface, NormalsAreInterpolatedAndUnit) {
  const Surface ball = surface_of(shapes::ball(24));
  for (std::uint32_t t = 0; t < ball.mesh().triangles.size(); t += 7) {
    const SurfacePoint point{t, {0.2, 0.3, 0.5}};
    EXPECT_NEAR(glm::length(ball.normal(point)), 1, 1e-12);
    EXPECT_GT(glm::dot(ball.normal(point), glm::normalize(ball.position(point))), 0.99);
  }
}

TEST(Surface, FindsVerticesAlongALine) {
  const Surface ball = surface_of(shapes::ball(20));
  const auto& positions = ball.mesh().positions;
  std::vector<std::uint32_t> found;
  for (const double x : {-0.6, -0.28, 0.0, 0.1, 0.28}) {
    for (const double end : {-0.1, 0.1, 0.6}) {  // before the ball, in it and beyond
      const glm::dvec3 from(x, 0.05, -0.6), to(x, 0.1 * x, end);
      std::vector<std::uint32_t> expected;
      for (std::uint32_t v = 0; v < positions.size(); ++v) {
        const glm::dvec3 line = to - from, off = glm::dvec3(positions[v]) - from;
        const double share = std::clamp(glm::dot(off, line) / glm::dot(line, line), 0.0, 1.0);
        if (glm::length(off - share * line) <= 0.07) expected.push_back(v);
      }
      ball.vertices_along(from, to, 0.07, found);
      EXPECT_EQ(found, expected) << x << " " << end;
    }
  }
  ball.vertices_along({0, 0, -1}, {0, 0, 1}, std::numeric_limits<double>::quiet_NaN(), found);
  EXPECT_TRUE(found.empty());
}

TEST(Surface, FindsVerticesWithinARadius) {
  const Surface ball = surface_of(shapes::ball(20));
  const glm::dvec3 vertex(ball.mesh().positions[17]);
  std::vector<std::uint32_t> found = {1, 2, 3};
  ball.vertices_within(vertex, 0, found);
  EXPECT_EQ(found, std::vector<std::uint32_t>{17});
  ball.vertices_within({0, 0, 0}, 0.01, found);
  EXPECT_TRUE(found.empty());
  for (const double all : {1.0, 1e6, std::numeric_limits<double>::infinity()}) {
    ball.vertices_within({0, 0, 0}, all, found);
    std::vector<std::uint32_t> expected(ball.mesh().positions.size());
    std::iota(expected.begin(), expected.end(), 0u);
    EXPECT_EQ(found, expected);
  }
  ball.vertices_within(vertex, -1, found);
  EXPECT_TRUE(found.empty());
  ball.vertices_within(vertex, std::numeric_limits<double>::quiet_NaN(), found);
  EXPECT_TRUE(found.empty());
}

TEST(Surface, NeighboursShareAnEdge) {
  const Surface cube = surface_of(shapes::cube());
  std::size_t sum = 0;
  for (std::uint32_t v = 0; v < 8; ++v) {
    const auto neighbours = cube.neighbours(v);
    EXPECT_TRUE(std::is_sorted(neighbours.begin(), neighbours.end()));
    for (std::uint32_t other : neighbours) {
      const auto back = cube.neighbours(other);
      EXPECT_TRUE(std::find(back.begin(), back.end(), v) != back.end());
    }
    sum += neighbours.size();
  }
  EXPECT_EQ(sum, 2u * 18u) << "a cube of triangles has 18 edges";
}

TEST(Surface, MovesAndStillAnswers) {
  Surface first = surface_of(shapes::cube());
  Surface second = surface_of(shapes::ball(8));
  second = std::move(first);
  EXPECT_EQ(second.mesh().positions.size(), 8u);
  EXPECT_TRUE(second.raycast({0, 1, 0.01}, {0, -1, 0}));
}

}  // namespace
}  // namespace pelage::surface_test
