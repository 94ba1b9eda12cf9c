#include "server/groom/evaluation_cost.h"

#include <cmath>

#include "base/limits.h"
#include "server/groom/evaluate.h"
#include "tests/unit/groom/shapes.h"

namespace pelage {
namespace {

using testing_shapes::make_surface;
using testing_shapes::stroke_through;

Symmetry images(int planes, int count) {
  Symmetry symmetry;
  symmetry.planes.resize(static_cast<std::size_t>(planes));
  symmetry.count = count;
  return symmetry;
}

class EvaluationCostTest : public ::testing::Test {
 protected:
  /// A stroke around the sphere.
  static Comb round(const Surface& surface, int samples, FalloffShape shape = FalloffShape::surface) {
    std::vector<glm::dvec3> positions;
    for (int i = 0; i < samples; ++i) positions.emplace_back(0.3 * std::cos(0.01 * i), 0.0, 0.3 * std::sin(0.01 * i));
    Comb comb;
    comb.stroke = stroke_through(surface, positions);
    comb.brush.falloff_shape = shape;
    return comb;
  }
  static double visits(const Command& command, const Surface& surface, const Symmetry& symmetry = {}) {
    return evaluation_cost(command, symmetry, surface, 0).visits;
  }

  Surface sphere_ = make_surface(Builtin::sphere, 2000);
};

TEST_F(EvaluationCostTest, GrowsWithImages) {
  const Comb comb = round(sphere_, 100);
  EXPECT_EQ(image_count(images(3, 16)), 128);
  EXPECT_DOUBLE_EQ(visits(comb, sphere_, images(3, 16)), 128 * visits(comb, sphere_));
  EXPECT_EQ(visits(Lift{.flood = true}, sphere_, images(3, 16)), visits(Lift{.flood = true}, sphere_));
}

TEST_F(EvaluationCostTest, GrowsWithSamplesVerticesAndDistanceAlongTheSurface) {
  const Comb comb = round(sphere_, 100);
  EXPECT_GT(visits(round(sphere_, 200), sphere_), 1.8 * visits(comb, sphere_));
  const Surface fine = make_surface(Builtin::sphere, 20000);
  EXPECT_GT(visits(round(fine, 100), fine), 3 * visits(comb, sphere_));
  EXPECT_GT(visits(comb, sphere_), 1.5 * visits(round(sphere_, 100, FalloffShape::volume), sphere_));
}

TEST_F(EvaluationCostTest, GrowsWithPassesKeysAndCurves) {
  const double one = visits(Smooth{.flood = true, .passes = 1}, sphere_);
  EXPECT_DOUBLE_EQ(visits(Smooth{.flood = true, .passes = 1000}, sphere_), 1000 * one);
  Interpolate keys{.keys = std::vector<Key>(2)};
  const double two = visits(keys, sphere_);
  keys.keys.resize(20);
  EXPECT_DOUBLE_EQ(visits(keys, sphere_), 10 * two);
  EXPECT_GT(visits(Flow{.curves = {{{0, 0, 0}, {1e6, 0, 0}}}}, sphere_),
            visits(Flow{.curves = {{{0, 0, 0}, {1, 0, 0}}}}, sphere_));
  EXPECT_EQ(visits(SetCoat{}, sphere_), 0);
}

TEST_F(EvaluationCostTest, SumsCommandsAndNamesTheFieldAndTheLimit) {
  const Comb comb = round(sphere_, 1000);
  double so_far = 0;
  EXPECT_TRUE(add_cost(comb, {}, sphere_, 0, so_far).ok());
  EXPECT_EQ(so_far, visits(comb, sphere_));
  so_far = limits::evaluation_visits;
  const Status refused = add_cost(comb, {}, sphere_, 0, so_far);
  EXPECT_EQ(refused.code, Code::invalid);
  EXPECT_EQ(refused.pointer, "/stroke/samples");
  EXPECT_NE(refused.limit.find(std::to_string(static_cast<long long>(limits::evaluation_visits))), std::string::npos);
}

}  // namespace
}  // namespace pelage
