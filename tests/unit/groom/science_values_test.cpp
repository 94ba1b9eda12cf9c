// The values that science.md 3 states, and distances that are known exactly.
#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <numbers>

#include "server/groom/evaluate.h"
#include "server/groom/first_groom.h"
#include "server/groom/keys.h"
#include "server/surface/geodesics.h"
#include "tests/unit/groom/shapes.h"

namespace pelage {
namespace {

using std::numbers::pi;
using testing_shapes::make_surface;
using testing_shapes::vertex_towards;

/// Weight of each source: the mean of a value that is 1 there and 0 elsewhere; 0 if no source is reached.
std::vector<double> weights_of(const std::vector<double>& distances, double sigma) {
  std::vector<double> weights(distances.size());
  for (std::size_t i = 0; i < weights.size(); ++i) {
    GaussianMean<double> mean;
    mean.add(
        distances.size(), sigma, [&](std::size_t k) { return distances[k]; },
        [&](std::size_t k) { return k == i ? 1.0 : 0.0; });
    weights[i] = mean.reached() ? mean.mean() : 0;
  }
  return weights;
}

// exp(-r^2 / 2) is a denormal float at 13.3 sigma and 0 at 14.5, where plain sums would give 0 / 0.
TEST(GaussianWeights, HoldFarBeyondTheRangeOfFloat) {
  ASSERT_LT(std::exp(-0.5f * 13.3f * 13.3f), std::numeric_limits<float>::min());
  ASSERT_EQ(std::exp(-0.5f * 14.5f * 14.5f), 0.0f);
  for (const double r : {13.3, 14.5, 40.0, 1e6}) {
    const std::vector<double> weights = weights_of({r, r, r + 1 / r}, 1);
    EXPECT_NEAR(weights[0] + weights[1] + weights[2], 1, 1e-12) << r;
    EXPECT_EQ(weights[0], weights[1]);
    const double last = r + 1 / r, over = (last - r) * (last + r) / 2;
    EXPECT_NEAR(weights[2] / weights[0], std::exp(-over), 1e-9) << r;
  }
}

TEST(GaussianWeights, AreZeroWhereNothingReaches) {
  constexpr double never = std::numeric_limits<double>::infinity();
  EXPECT_EQ(weights_of({never, never}, 0.1), (std::vector<double>{0, 0}));
  EXPECT_EQ(weights_of({never, 5, never}, 1e-6), (std::vector<double>{0, 1, 0}));
}

/// Carries a direction around the circle at a colatitude of 85 degrees in 8 steps. Returns how many degrees it is off
/// the exact rotation by parallel transport, 360 (1 - cos 85), in the frame of its start.
double error_around_the_loop(bool by_projection) {
  constexpr double colatitude = 85 * pi / 180;
  constexpr int steps = 8;
  const auto normal = [&](int k) {
    const double longitude = 2 * pi * k / steps;
    return glm::dvec3(std::sin(colatitude) * std::cos(longitude), std::sin(colatitude) * std::sin(longitude),
                      std::cos(colatitude));
  };
  const glm::dvec3 south(std::cos(colatitude), 0, -std::sin(colatitude)), east(0, 1, 0);
  glm::dvec3 v = east;
  const double before = std::atan2(glm::dot(v, east), glm::dot(v, south));
  for (int k = 0; k < steps; ++k) {
    v = by_projection ? v - glm::dot(v, normal(k + 1)) * normal(k + 1) : transported(v, normal(k), normal(k + 1));
  }
  const double turned = (std::atan2(glm::dot(v, east), glm::dot(v, south)) - before) * 180 / pi;
  const double expected = -360 * std::cos(colatitude);  // relative to the frame of south and east
  return std::abs(std::remainder(turned - expected, 360));
}

TEST(Transport, IsRightAroundTheColatitudeLoopWhereProjectionIsNot) {
  EXPECT_NEAR(error_around_the_loop(false), 1.7, 0.1);
  EXPECT_NEAR(error_around_the_loop(true), 49, 1);
}

TEST(Transport, KeepsLengthAndPlaneHoweverOppositeTheNormals) {
  const glm::dvec3 from(0, 0, 1);
  for (const double d : {-1.0, -1 + 1e-7, -1 + 1e-9, -0.5, 0.0, 1.0}) {
    const glm::dvec3 to(std::sqrt(std::max(0.0, 1 - d * d)), 0, d);
    for (const glm::dvec3 v : {glm::dvec3(1, 0, 0), glm::dvec3(0, 1, 0), glm::normalize(glm::dvec3(1, -2, 0))}) {
      const glm::dvec3 brought = transported(v, from, to);
      EXPECT_NEAR(glm::length(brought), 1, 1e-12) << d;
      EXPECT_NEAR(glm::dot(brought, to), 0, 1e-4) << d;
    }
  }
  EXPECT_EQ(transported({1, 2, 0}, from, from), glm::dvec3(1, 2, 0));
}

// Normals are 32-bit numbers whose length is off by up to 1e-7, so 1 + d of opposite ones is only rounding error.
TEST(Transport, KeepsLengthBetweenRoundedNormals) {
  for (const double off : {-1e-7, 1e-7}) {
    for (const double tilt : {1e-5, 1e-4, 4e-4, 1e-3}) {
      const glm::dvec3 from(0, 0, 1 + off), to(tilt, 0, -(1 - tilt * tilt / 2) * (1 + off));
      EXPECT_NEAR(glm::length(transported({1, 0, 0}, from, to)), 1, 1e-9) << off << " " << tilt;
    }
  }
}

TEST(Smoothing, IsMonotoneUpToAHalf) {
  const Surface sphere = make_surface(Builtin::sphere, 500);
  FieldSet before(sphere.mesh().positions.size());
  for (std::uint32_t v = 0; v < before.size(); ++v)
    before.set(Field::density, v, glm::vec4(v % 3 == 0 ? 1 : 0, 0, 0, 0));
  const auto spread = [](const FieldSet& fields) {
    const auto [min, max] =
        std::minmax_element(fields.values(Field::density).begin(), fields.values(Field::density).end());
    return *max - *min;
  };
  for (const double t : {0.1, 0.25, 0.5}) {
    Smooth smooth;
    smooth.flood = true, smooth.t = t, smooth.passes = 1, smooth.fields = {Field::density};
    smooth.brush.strength = 1;
    FieldSet fields = before;
    float last = spread(before);
    for (int pass = 0; pass < 50; ++pass) {
      fields.apply(evaluate(smooth, sphere, fields).delta);
      ASSERT_LE(spread(fields), last) << t << " at pass " << pass;
      last = spread(fields);
    }
    EXPECT_LT(last, 0.6f);
  }
}

/// Largest error of distances from a vertex, as a share of the largest distance.
double heat_error(const Surface& surface, std::uint32_t source, const std::function<double(glm::dvec3)>& exact) {
  const Spread spread = Spreader(surface, DistanceKind::heat)(std::vector<SpreadSource>{{source, 0, glm::dvec3(0)}});
  double worst = 0, largest = 0;
  for (std::uint32_t v = 0; v < spread.distance.size(); ++v) {
    const double expected = exact(glm::dvec3(surface.mesh().positions[v]));
    worst = std::max(worst, std::abs(spread.distance[v] - expected));
    largest = std::max(largest, expected);
  }
  return worst / largest;
}

TEST(HeatDistances, AreThoseOfThePlaneAndOfTheSphere) {
  const Surface plane = make_surface(Builtin::plane, 8000);
  const std::uint32_t middle = vertex_towards(plane, {0, 1, 0}), corner = vertex_towards(plane, {1, 0, 1});
  for (const std::uint32_t source : {middle, corner}) {
    const glm::dvec3 from(plane.mesh().positions[source]);
    EXPECT_LT(heat_error(plane, source, [&](glm::dvec3 p) { return glm::distance(p, from); }), 0.02);
  }
  const Surface sphere = make_surface(Builtin::sphere, 8000);
  const std::uint32_t pole = vertex_towards(sphere, {0, 0, 1});
  const glm::dvec3 from(sphere.mesh().positions[pole]);
  const double radius = glm::length(from);
  EXPECT_LT(heat_error(sphere, pole,
                       [&](glm::dvec3 p) {
                         return radius * std::acos(std::clamp(glm::dot(glm::normalize(p), from / radius), -1.0, 1.0));
                       }),
            0.02);
}

// Halfway between two keys both weigh the same; elsewhere weights follow the distance along the sphere.
TEST(HeatDistances, WeighKeysByTheDistanceAlongTheSurface) {
  const Surface sphere = make_surface(Builtin::sphere, 8000);
  const FieldSet before = first_groom(sphere.mesh(), {});
  Interpolate keys;
  keys.distance = DistanceKind::heat;
  keys.sigma = 0.3;
  keys.keys = {Key{.position = sphere.mesh().to_model({0, 0, 0.3}), .length = 0.1},
               Key{.position = sphere.mesh().to_model({0, 0, -0.3}), .length = 0.2}};
  FieldSet fields = before;
  fields.apply(evaluate(keys, sphere, before).delta);
  const double radius = glm::length(glm::dvec3(sphere.mesh().positions[0]));
  for (std::uint32_t v = 0; v < fields.size(); ++v) {
    const double angle = std::acos(std::clamp(glm::normalize(glm::dvec3(sphere.mesh().positions[v])).z, -1.0, 1.0));
    const double front = radius * angle, back = radius * (pi - angle);
    const double share = 1 / (1 + std::exp((back * back - front * front) / (2 * 0.09)));
    ASSERT_NEAR(fields.at(v).length, 0.1 + 0.1 * share, 0.003);
  }
}

}  // namespace
}  // namespace pelage
