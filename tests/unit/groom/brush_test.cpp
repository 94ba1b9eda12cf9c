#include "server/groom/brush.h"

#include "tests/unit/groom/shapes.h"

namespace pelage {
namespace {

using testing_shapes::make_surface;
using testing_shapes::stroke_through;

class BrushTest : public ::testing::Test {
 protected:
  std::vector<Dab> dabs(const std::vector<glm::dvec3>& points, Brush brush) const {
    return BrushStroke(stroke_through(sphere_, points), brush, sphere_, fields_).moving_dabs();
  }
  Surface sphere_ = make_surface(Builtin::sphere, 2000);
  FieldSet fields_{sphere_.mesh().positions.size()};
};

TEST_F(BrushTest, FalloffCurves) {
  for (const Falloff curve : {Falloff::constant, Falloff::linear, Falloff::smooth, Falloff::sharp, Falloff::sphere}) {
    EXPECT_EQ(falloff_weight(curve, 0), 1);
    EXPECT_EQ(falloff_weight(curve, 1.0001), 0);
  }
  EXPECT_EQ(falloff_weight(Falloff::constant, 1), 1);
  EXPECT_EQ(falloff_weight(Falloff::linear, 0.25), 0.75);
  EXPECT_EQ(falloff_weight(Falloff::smooth, 0.5), 0.5);
  EXPECT_EQ(falloff_weight(Falloff::sharp, 0.5), 0.25);
  EXPECT_NEAR(falloff_weight(Falloff::sphere, 0.6), 0.8, 1e-15);
}

TEST_F(BrushTest, OneDabForEachStepAndTheRest) {
  const std::vector<Dab> found = dabs({{0, 0, 0}, {0.1, 0, 0}, {0.26, 0, 0}}, {.radius = 0.1, .spacing = 0.5});
  ASSERT_EQ(found.size(), 6u);
  for (std::size_t k = 0; k < 5; ++k) {
    EXPECT_NEAR(found[k].centre.x, 0.05 * static_cast<double>(k + 1), 1e-12);
    EXPECT_NEAR(found[k].step, 0.5, 1e-12);
    EXPECT_NEAR(glm::distance(found[k].motion, glm::dvec3(1, 0, 0)), 0, 1e-12);
  }
  EXPECT_NEAR(found[5].centre.x, 0.26, 1e-12);
  EXPECT_NEAR(found[5].step, 0.1, 1e-9);
}

TEST_F(BrushTest, DabsDoNotDependOnTheSamplingRate) {
  std::vector<glm::dvec3> fine;
  for (int i = 0; i <= 240; ++i) fine.push_back({0.5 * i / 240, 0.1, 0});
  const Brush brush{.radius = 0.07, .spacing = 0.25};
  const std::vector<Dab> coarse_dabs = dabs({{0, 0.1, 0}, {0.5, 0.1, 0}}, brush), fine_dabs = dabs(fine, brush);
  ASSERT_EQ(coarse_dabs.size(), fine_dabs.size());
  for (std::size_t k = 0; k < fine_dabs.size(); ++k) {
    EXPECT_NEAR(glm::distance(coarse_dabs[k].centre, fine_dabs[k].centre), 0, 1e-12);
  }
}

TEST_F(BrushTest, WithoutMotionThereIsNoDab) {
  EXPECT_TRUE(dabs({{0, 0, 0.3}}, {}).empty());
  EXPECT_TRUE(dabs({{0, 0, 0.3}, {0, 0, 0.3}}, {}).empty());
  EXPECT_TRUE(dabs({{0, 0, 0.3}, {0, 0.1, 0.3}}, {.radius = 0}).empty());
  const BrushStroke still(stroke_through(sphere_, {{0, 0, 0.3}}), {}, sphere_, fields_);
  EXPECT_EQ(still.covering_dabs().size(), 1u);
}

TEST_F(BrushTest, PressureIsInterpolated) {
  Stroke stroke = stroke_through(sphere_, {{0, 0, 0}, {0.2, 0, 0}});
  stroke.samples[0].pressure = 0;
  const Brush brush{.radius = 0.1, .spacing = 1};
  const std::vector<Dab> found = BrushStroke(stroke, brush, sphere_, fields_).moving_dabs();
  ASSERT_EQ(found.size(), 2u);
  EXPECT_NEAR(found[0].pressure, 0.5, 1e-12);
  EXPECT_NEAR(found[1].pressure, 1, 1e-12);
}

TEST_F(BrushTest, WorldUnitsAreTheModelsOwn) {
  const Brush brush{.radius = 3, .units = Units::world};
  EXPECT_NEAR(internal_length(brush.radius, brush.units, sphere_.mesh()), 3 / sphere_.mesh().size, 1e-15);
  EXPECT_EQ(internal_length(3, Units::relative, sphere_.mesh()), 3);
}

TEST_F(BrushTest, FrontFacesOnlyLeavesTheFarSide) {
  const Stroke stroke = stroke_through(sphere_, {{0, 0, 0.28}, {0, 0.02, 0.28}});
  Brush brush{.radius = 2, .falloff = Falloff::constant, .strength = 1};
  std::vector<VertexWeight> front, all;
  const BrushStroke near_side(stroke, brush, sphere_, fields_);
  near_side.weigh(near_side.covering_dabs().front(), front);
  brush.front_faces_only = false;
  const BrushStroke both_sides(stroke, brush, sphere_, fields_);
  both_sides.weigh(both_sides.covering_dabs().front(), all);
  EXPECT_EQ(all.size(), sphere_.mesh().positions.size());
  EXPECT_GT(front.size(), all.size() / 3);
  EXPECT_LT(front.size(), all.size() * 2 / 3);
  for (const auto [vertex, weight] : front) {
    EXPECT_GT(sphere_.mesh().normals[vertex].z, -0.05);
    EXPECT_EQ(weight, 1);
  }
}

TEST_F(BrushTest, WithAViewFrontFacesAreJudgedAgainstIt) {
  Stroke stroke = stroke_through(sphere_, {{0, 0, 0.28}, {0, 0.02, 0.28}});
  stroke.view = View{.camera = {.automatic = AutoView::back}};
  const Brush brush{.radius = 2};
  const BrushStroke painted(stroke, brush, sphere_, fields_);
  std::vector<VertexWeight> weights;
  painted.weigh(painted.covering_dabs().front(), weights);
  ASSERT_FALSE(weights.empty());
  for (const VertexWeight w : weights) EXPECT_LT(sphere_.mesh().normals[w.vertex].z, 0);
}

TEST_F(BrushTest, PathBetweenSurfaceSamplesFollowsTheSurface) {
  Stroke stroke;
  for (const glm::dvec3 from : {glm::dvec3(0, 0, 2), glm::dvec3(2, 0, 0)}) {
    const SurfacePoint point = sphere_.nearest(from);
    StrokeSample sample;
    sample.place = SurfacePlace{point.triangle, point.barycentric};
    stroke.samples.push_back(sample);
  }
  const double radius = glm::length(glm::dvec3(sphere_.mesh().positions[0]));
  for (const Dab& dab : BrushStroke(stroke, {}, sphere_, fields_).moving_dabs()) {
    EXPECT_NEAR(glm::length(dab.centre), radius, 0.02 * radius);
  }
}

TEST_F(BrushTest, CoverageIsTheLargestWeightOfAnyDab) {
  const Stroke stroke = stroke_through(sphere_, {{0, 0, 0.28}, {0, 0.1, 0.27}});
  const Brush brush{.radius = 0.1, .falloff = Falloff::linear, .strength = 0.5};
  const BrushStroke painted(stroke, brush, sphere_, fields_);
  std::vector<double> expected(sphere_.mesh().positions.size());
  std::vector<VertexWeight> weights;
  for (const Dab& dab : painted.covering_dabs()) {
    painted.weigh(dab, weights);
    for (const VertexWeight w : weights) expected[w.vertex] = std::max(expected[w.vertex], w.weight);
  }
  const std::vector<VertexWeight> covered = coverage(stroke, brush, sphere_, fields_);
  ASSERT_GT(covered.size(), 10u);
  for (const VertexWeight w : covered) EXPECT_EQ(w.weight, expected[w.vertex]);
}

}  // namespace
}  // namespace pelage
