#include "server/groom/brush.h"

#include <cmath>
#include <map>

#include "tests/unit/groom/shapes.h"

namespace pelage {
namespace {

using testing_shapes::make_surface;
using testing_shapes::stroke_through;
using testing_shapes::vertex_towards;

class BrushTest : public ::testing::Test {
 protected:
  std::vector<Dab> dabs(const std::vector<glm::dvec3>& points, Brush brush) const {
    return BrushStroke(stroke_through(sphere_, points), brush, sphere_).moving_dabs();
  }
  Surface sphere_ = make_surface(Builtin::sphere, 2000);
};

TEST_F(BrushTest, FalloffIsOneInTheMiddleAndZeroOutside) {
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
  const BrushStroke still(stroke_through(sphere_, {{0, 0, 0.3}}), {}, sphere_);
  EXPECT_EQ(still.covering_dabs().size(), 1u);
}

TEST_F(BrushTest, PressureIsInterpolated) {
  Stroke stroke = stroke_through(sphere_, {{0, 0, 0}, {0.2, 0, 0}});
  stroke.samples[0].pressure = 0;
  const Brush brush{.radius = 0.1, .spacing = 1};
  const std::vector<Dab> found = BrushStroke(stroke, brush, sphere_).moving_dabs();
  ASSERT_EQ(found.size(), 2u);
  EXPECT_NEAR(found[0].pressure, 0.5, 1e-12);
  EXPECT_NEAR(found[1].pressure, 1, 1e-12);
}

TEST_F(BrushTest, WorldUnitsAreTheModelsOwn) {
  const Stroke stroke = stroke_through(sphere_, {{0, 0, 0.28}});
  const double size = sphere_.mesh().size;
  EXPECT_NEAR(BrushStroke(stroke, {.radius = 3, .units = RadiusUnits::world}, sphere_).radius(), 3 / size, 1e-15);
  EXPECT_EQ(BrushStroke(stroke, {.radius = 3}, sphere_).radius(), 3);
  EXPECT_NEAR(internal_length(3, Units::world, sphere_.mesh()), 3 / size, 1e-15);
  EXPECT_EQ(internal_length(3, Units::relative, sphere_.mesh()), 3);
}

TEST_F(BrushTest, FrontFacesOnlyLeavesTheFarSide) {
  const Stroke stroke = stroke_through(sphere_, {{0, 0, 0.28}, {0, 0.02, 0.28}});
  Brush brush{.radius = 2, .falloff = Falloff::constant, .strength = 1};
  std::vector<VertexWeight> front, all;
  const BrushStroke near_side(stroke, brush, sphere_);
  near_side.weigh(near_side.covering_dabs().front(), front);
  brush.front_faces_only = false;
  const BrushStroke both_sides(stroke, brush, sphere_);
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
  const BrushStroke painted(stroke, brush, sphere_);
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
    sample.position = SurfaceSample{point.triangle, point.barycentric};
    stroke.samples.push_back(sample);
  }
  const double radius = glm::length(glm::dvec3(sphere_.mesh().positions[0]));
  for (const Dab& dab : BrushStroke(stroke, {}, sphere_).moving_dabs()) {
    EXPECT_NEAR(glm::length(dab.centre), radius, 0.02 * radius);
  }
}

TEST_F(BrushTest, CoverageIsTheLargestWeightOfAnyDab) {
  const Stroke stroke = stroke_through(sphere_, {{0, 0, 0.28}, {0, 0.1, 0.27}});
  const Brush brush{.radius = 0.1, .falloff = Falloff::linear, .strength = 0.5};
  const BrushStroke painted(stroke, brush, sphere_);
  std::vector<double> expected(sphere_.mesh().positions.size());
  std::vector<VertexWeight> weights;
  for (const Dab& dab : painted.covering_dabs()) {
    painted.weigh(dab, weights);
    for (const VertexWeight w : weights) expected[w.vertex] = std::max(expected[w.vertex], w.weight);
  }
  const std::vector<VertexWeight> covered = region_of(stroke, brush, sphere_, FieldSet(expected.size()), {});
  ASSERT_GT(covered.size(), 10u);
  for (const VertexWeight w : covered) EXPECT_EQ(w.weight, expected[w.vertex]);
}

/// The view of a camera on +Z that looks at the model's middle.
View front_view(const Surface& surface) {
  View view;
  view.camera.automatic = AutoView::none;
  view.camera.position = surface.mesh().to_model({0, 0, 2});
  view.camera.target = surface.mesh().to_model({0, 0, 0});
  view.camera.fov_degrees = 30;
  view.width = 400, view.height = 200;
  return view;
}

TEST_F(BrushTest, ARadiusInPixelsIsWhatThePixelsCoverAtTheSamplesDepth) {
  Stroke stroke = stroke_through(sphere_, {{0, 0, 0.25}});
  stroke.view = front_view(sphere_);
  const double depth = 1.75, expected = 20 * 2 * std::tan(glm::radians(15.0)) * depth / 200;
  EXPECT_NEAR(BrushStroke(stroke, {.radius = 20, .units = RadiusUnits::pixels}, sphere_).radius(), expected, 1e-9);
}

TEST_F(BrushTest, TheScreenShapeReachesWhatLiesUnderTheDiscAtAnyDepth) {
  Stroke stroke = stroke_through(sphere_, {{0, 0, 0.28}});
  stroke.view = front_view(sphere_);
  const Brush brush{.radius = 0.1, .falloff_shape = FalloffShape::screen, .front_faces_only = false};
  const BrushStroke painted(stroke, brush, sphere_);
  std::vector<VertexWeight> weights;
  painted.weigh(painted.covering_dabs().front(), weights);
  bool near = false, far = false;
  for (const VertexWeight w : weights) {
    const glm::dvec3 p(sphere_.mesh().positions[w.vertex]);
    const double scale = (2 - 0.28) / (2 - p.z);
    EXPECT_LE(glm::length(glm::dvec2(p)) * scale, 0.1 + 1e-9);
    near = near || p.z > 0.2, far = far || p.z < -0.2;
  }
  EXPECT_TRUE(near && far);
}

/// The torus has two parallel sheets that are near in space and far apart along the surface.
TEST_F(BrushTest, TheSurfaceShapeDoesNotReachAnotherSheet) {
  const Surface torus = make_surface(Builtin::torus, 3000);
  const glm::dvec3 inside(torus.mesh().positions[vertex_towards(torus, {1, 0, 0})]);
  const Stroke stroke = stroke_through(torus, {inside});
  Brush brush{.radius = 0.3, .falloff = Falloff::constant, .front_faces_only = false};
  const FieldSet fields(torus.mesh().positions.size());
  const std::size_t volume = region_of(stroke, brush, torus, fields, {}).size();
  brush.falloff_shape = FalloffShape::surface;
  const std::vector<VertexWeight> surface = region_of(stroke, brush, torus, fields, {});
  EXPECT_LT(surface.size(), volume);
  EXPECT_GT(surface.size(), 20u);
}

TEST_F(BrushTest, PressureScalesRadiusAndStrengthByTheirShares) {
  Stroke stroke = stroke_through(sphere_, {{0, 0, 0.28}});
  stroke.samples[0].pressure = 0.5;
  const Dab dab = BrushStroke(stroke, {.radius = 0.2, .pressure_to_radius = 0.5}, sphere_).covering_dabs().front();
  EXPECT_NEAR(dab.radius, 0.15, 1e-12);
  const Brush brush{.radius = 0.2, .falloff = Falloff::constant, .strength = 0.8, .pressure_to_strength = 0.25};
  EXPECT_NEAR(region_of(stroke, brush, sphere_, FieldSet(sphere_.mesh().positions.size()), {})[0].weight, 0.7, 1e-12);
}

TEST_F(BrushTest, FalloffPointsReplaceTheCurve) {
  const Brush brush{.falloff = Falloff::constant, .falloff_points = {1, 0.5, 0}};
  EXPECT_EQ(falloff_weight(brush, 0), 1);
  EXPECT_EQ(falloff_weight(brush, 0.25), 0.75);
  EXPECT_EQ(falloff_weight(brush, 0.5), 0.5);
  EXPECT_EQ(falloff_weight(brush, 1), 0);
  EXPECT_EQ(falloff_weight(brush, 1.01), 0);
}

TEST_F(BrushTest, TheCutOffAngleTakesFacesThatTurnAway) {
  const Stroke stroke = stroke_through(sphere_, {{0, 0, 0.288}});
  const FieldSet fields(sphere_.mesh().positions.size());
  Brush brush{.radius = 2, .falloff = Falloff::constant, .cut_off_degrees = 30};
  for (const VertexWeight w : region_of(stroke, brush, sphere_, fields, {}))
    EXPECT_GT(sphere_.mesh().normals[w.vertex].z, 0.8f);
  const std::size_t narrow = region_of(stroke, brush, sphere_, fields, {}).size();
  brush.cut_off_degrees = 180;
  EXPECT_GT(region_of(stroke, brush, sphere_, fields, {}).size(), 4 * narrow);
}

/// A picture whose right half is white, seen with its top up.
MapPicture right_half() {
  constexpr int side = 16;
  MapPicture picture{side, side, 8, {}, {}};
  for (int k = 0; k < side * side; ++k) {
    const float grey = k % side < side / 2 ? 0.0f : 1.0f;
    picture.rgba.insert(picture.rgba.end(), {grey, grey, grey, 1});
  }
  return picture;
}

TEST_F(BrushTest, AnAlphaIsPrintedWithItsTopToWhereTheStrokeGoes) {
  const MapPicture picture = right_half();
  const Brush brush{.radius = 0.2, .falloff = Falloff::constant, .strength = 1};
  const glm::dvec3 front(0, 0, 0.5 / std::sqrt(3.0));
  for (const glm::dvec3 motion : {glm::dvec3(0, 1, 0), glm::dvec3(1, 0, 0), glm::dvec3(0, -1, 0), glm::dvec3(0)}) {
    const BrushStroke plain(stroke_through(sphere_, {front}), brush, sphere_),
        printed(stroke_through(sphere_, {front}), brush, sphere_, nullptr, &picture);
    Dab dab = plain.covering_dabs().front();
    dab.motion = motion;
    const glm::dvec3 up = motion == glm::dvec3(0) ? glm::dvec3(0, 1, 0) : motion;
    const glm::dvec3 right = glm::cross(up, glm::dvec3(0, 0, 1));
    std::vector<VertexWeight> all, bright;
    plain.weigh(dab, all), printed.weigh(dab, bright);
    std::map<std::uint32_t, double> weights;
    for (const auto [vertex, weight] : bright) weights[vertex] = weight;
    ASSERT_GT(all.size(), 20u);
    for (const auto [vertex, weight] : all) {
      const double side = glm::dot(glm::dvec3(sphere_.mesh().positions[vertex]), right);
      if (std::abs(side) < 0.03 || std::abs(side) > 0.17) continue;  // within a pixel of an edge
      EXPECT_NEAR(weights[vertex], side > 0 ? weight : 0, 1e-6) << vertex;
    }
  }
}

TEST_F(BrushTest, TheFirstDabOfAStrokePointsToTheNext) {
  const BrushStroke stroke(stroke_through(sphere_, {{0, 0, 0.3}, {0.2, 0, 0.3}}), {}, sphere_);
  EXPECT_NEAR(glm::distance(stroke.covering_dabs().front().motion, glm::dvec3(1, 0, 0)), 0, 1e-12);
}

TEST_F(BrushTest, TheMaskScalesEveryWeight) {
  FieldSet fields(sphere_.mesh().positions.size());
  fields.set(Field::mask, 5, {0.25f, 0, 0, 0});
  fields.set(Field::mask, 6, {0, 0, 0, 0});
  const std::vector<VertexWeight> region = region_of({}, {.strength = 0.8}, sphere_, fields, {});
  EXPECT_EQ(region.size(), fields.size() - 1);
  EXPECT_NEAR(region[5].weight, 0.2, 1e-12);
  EXPECT_EQ(region[6].vertex, 7u);
  EXPECT_EQ(region_of({}, {.strength = 0.8}, sphere_, fields, {}, Masked::no).size(), fields.size());
}

}  // namespace
}  // namespace pelage
