#include <cmath>

#include "base/limits.h"
#include "server/groom/evaluate.h"
#include "tests/unit/groom/shapes.h"

namespace pelage {
namespace {

using testing_shapes::make_surface;
using testing_shapes::stroke_through;

class ResolveTest : public ::testing::Test {
 protected:
  static StrokeSample pixel(double x, double y) {
    StrokeSample sample;
    sample.position = ScreenSample{{x, y}};
    return sample;
  }
  Status refusal(const Command& command) const {
    const Result<Command> resolved = resolve(command, sphere_);
    return resolved.ok() ? Status{} : resolved.status();
  }
  Surface sphere_ = make_surface(Builtin::sphere, 2000);
};

TEST_F(ResolveTest, PixelsBecomePositionsAndMissesAreDropped) {
  Comb comb;
  comb.stroke = Stroke{};
  comb.stroke->view = View{.camera = {.automatic = AutoView::front}, .width = 200, .height = 100};
  comb.stroke->samples = {pixel(1, 1), pixel(100, 50), pixel(105, 50)};
  const Result<Command> resolved = resolve(comb, sphere_);
  ASSERT_TRUE(resolved.ok());
  const Stroke& stroke = *stroke_of(*resolved);
  ASSERT_EQ(stroke.samples.size(), 2u);
  ASSERT_TRUE(stroke.view.has_value());
  const auto& sample = std::get<SurfaceSample>(stroke.samples[0].position);
  const glm::dvec3 hit = sphere_.position({sample.triangle, sample.barycentric});
  EXPECT_NEAR(hit.x, 0, 1e-3);
  EXPECT_NEAR(hit.y, 0, 1e-3);
  EXPECT_GT(hit.z, 0.2);
}

/// Resolves pixels of a front view of a ball with upright fur 0.1 sizes long.
class ResolveToFurTest : public ResolveTest {
 protected:
  ResolveToFurTest() : fields_(static_cast<std::uint32_t>(sphere_.mesh().positions.size())) {
    for (std::uint32_t v = 0; v < fields_.size(); ++v) fields_.set(Field::length, v, glm::vec4(0.1f));
    comb_.stroke = Stroke{};
    comb_.stroke->view = View{.camera = {.automatic = AutoView::front}, .width = 400, .height = 400};
  }
  Result<Command> try_to_resolve(std::vector<StrokeSample> samples) {
    comb_.stroke->samples = std::move(samples);
    const VisibleFur fur{fields_, coats_, visits_, cancel_};
    return resolve(comb_, sphere_, &fur);
  }
  Comb resolved(std::vector<StrokeSample> samples) {
    const Result<Command> done = try_to_resolve(std::move(samples));
    EXPECT_TRUE(done.ok());
    return done.ok() ? std::get<Comb>(*done) : Comb{};
  }
  /// Distance of the sample from the ball's middle; 0 if it is not a PositionSample.
  double height(const StrokeSample& sample) const {
    const auto* in_space = std::get_if<PositionSample>(&sample.position);
    return in_space ? glm::length(sphere_.mesh().to_internal(in_space->position)) : 0;
  }

  FieldSet fields_;
  std::vector<NamedCoat> coats_{1};
  Comb comb_;
  double visits_ = 0;
  Cancel cancel_;
  const double radius_ = glm::length(glm::dvec3(sphere_.mesh().positions[0]));
};

TEST_F(ResolveToFurTest, PixelsAreOnTheFurThatIsSeenThere) {
  const Comb done = resolved({pixel(200, 200), pixel(210, 200)});
  ASSERT_EQ(done.stroke->samples.size(), 2u);
  EXPECT_EQ(done.brush.reach, Reach::fur);
  for (const StrokeSample& sample : done.stroke->samples) {
    EXPECT_GT(height(sample), radius_ + 0.03);
    EXPECT_LT(height(sample), radius_ + 0.11);
  }
}

TEST_F(ResolveToFurTest, PixelsBesideTheSkinAreOnTheFurThatStandsThere) {
  const PlacedCamera camera = place_camera(comb_.stroke->view->camera, 1, sphere_.mesh());
  const double depth = glm::length(camera.position), pixels = 200 / (camera.tan_half_fov * depth);
  const Comb done = resolved({pixel(200 + pixels * (radius_ + 0.08), 200), pixel(200 + pixels * (radius_ + 0.3), 200)});
  ASSERT_EQ(done.stroke->samples.size(), 1u);  // the other pixel is beyond the tips
  EXPECT_NEAR(height(done.stroke->samples[0]), radius_ + 0.08, 0.04);
}

TEST_F(ResolveToFurTest, BrushesForSkinSeeSkin) {
  comb_.brush.reach = Reach::skin;
  const Comb done = resolved({pixel(200, 200)});
  ASSERT_EQ(done.stroke->samples.size(), 1u);
  EXPECT_TRUE(std::holds_alternative<SurfaceSample>(done.stroke->samples[0].position));
}

TEST_F(ResolveToFurTest, PositionsInSpaceAndOtherShapesKeepToTheSkin) {
  comb_.stroke->view.reset();
  EXPECT_FALSE(resolved(stroke_through(sphere_, {{0, 0, 0.3}}).samples).brush.reach.has_value());
  comb_.stroke->view = View{.camera = {.automatic = AutoView::front}};
  comb_.brush.falloff_shape = FalloffShape::surface;
  EXPECT_FALSE(resolved({pixel(200, 200)}).brush.reach.has_value());
}

TEST_F(ResolveToFurTest, PixelsOfARequestCostTogetherAndAreRefusedBeyondTheLimit) {
  resolved({pixel(200, 200)});
  const double one = visits_;
  EXPECT_GT(one, 0);
  resolved({pixel(200, 200), pixel(200, 200)});
  EXPECT_DOUBLE_EQ(visits_, 3 * one);
  visits_ = limits::evaluation_visits;
  const Result<Command> refused = try_to_resolve({pixel(200, 200)});
  ASSERT_FALSE(refused.ok());
  EXPECT_EQ(refused.status().code, Code::invalid);
  EXPECT_EQ(refused.status().pointer, "/stroke/samples");
}

TEST_F(ResolveToFurTest, NoMorePixelsAreLookedAtOnceNobodyWaits) {
  int asked = 0;
  cancel_ = Cancel([&] { return ++asked == 2; });
  const Result<Command> ended = try_to_resolve({pixel(200, 200), pixel(210, 200), pixel(220, 200)});
  ASSERT_FALSE(ended.ok());
  EXPECT_EQ(ended.status().code, Code::unavailable);
  EXPECT_EQ(asked, 2);
}

TEST_F(ResolveTest, ResolvingAgainChangesNothing) {
  Comb comb;
  comb.stroke = Stroke{};
  comb.stroke->view = View{.camera = {.automatic = AutoView::left}};
  comb.stroke->samples = {pixel(256, 256), pixel(300, 200)};
  const Result<Command> once = resolve(comb, sphere_);
  ASSERT_TRUE(once.ok());
  const Result<Command> twice = resolve(*once, sphere_);
  ASSERT_TRUE(twice.ok());
  for (std::size_t i = 0; i < 2; ++i) {
    const auto& a = std::get<SurfaceSample>(stroke_of(*once)->samples[i].position);
    const auto& b = std::get<SurfaceSample>(stroke_of(*twice)->samples[i].position);
    EXPECT_EQ(a.triangle, b.triangle);
    EXPECT_EQ(a.barycentric, b.barycentric);
  }
}

TEST_F(ResolveTest, RefusesWhatTheSurfaceDoesNotHave) {
  Comb comb;
  comb.stroke = stroke_through(sphere_, {{0, 0, 0.3}, {0, 0.1, 0.3}});
  comb.stroke->samples[1].position = SurfaceSample{1u << 30, {1, 0, 0}};
  EXPECT_EQ(refusal(comb).code, Code::invalid);
  EXPECT_EQ(refusal(comb).pointer, "/stroke/samples/1/triangle");
  EXPECT_EQ(refusal(comb).limit, "below " + std::to_string(sphere_.mesh().triangles.size()));
}

TEST_F(ResolveTest, RefusesCoordinatesBeyondAMillionSizes) {
  Comb comb;
  comb.stroke = stroke_through(sphere_, {{0, 0, 0.3}, {0, 2e6, 0.3}});
  EXPECT_EQ(refusal(comb).pointer, "/stroke/samples/1/position");
  comb.stroke = stroke_through(sphere_, {{0, 0, 0.3}, {std::nan(""), 0, 0.3}});
  EXPECT_EQ(refusal(comb).pointer, "/stroke/samples/1/position");
  Blow blow;
  blow.source = {1e300, 0, 0};
  EXPECT_EQ(refusal(blow).pointer, "/source");
  Attract attract;
  attract.point = {0, -1e9, 0};
  EXPECT_EQ(refusal(attract).pointer, "/point");
  attract.point = {0, 0, 0};
  attract.radius = 1e7;
  EXPECT_EQ(refusal(attract).pointer, "/radius");
}

TEST_F(ResolveTest, RefusesAStrokeOfTooManyDabs) {
  Comb comb;
  comb.stroke = stroke_through(sphere_, {{0, 0, 0.3}, {0, 0.5, 0.3}});
  comb.brush.radius = 1e-5;
  EXPECT_EQ(refusal(comb).pointer, "/brush/spacing");
  comb.brush.radius = 1e-4;
  EXPECT_TRUE(refusal(comb).ok());
  comb.brush.radius = 1e-320;
  EXPECT_EQ(refusal(comb).pointer, "/brush/spacing");
}

TEST_F(ResolveTest, PixelsNeedAView) {
  Comb comb;
  comb.stroke = Stroke{};
  comb.stroke->samples = {pixel(1, 1)};
  EXPECT_EQ(refusal(comb).pointer, "/stroke/view");
}

TEST_F(ResolveTest, AutomaticCamerasFrameTheBoxAndNearlyFillThePicture) {
  const Mesh& mesh = sphere_.mesh();
  for (const AutoView view :
       {AutoView::front, AutoView::back, AutoView::left, AutoView::right, AutoView::top, AutoView::three_quarter}) {
    for (const double aspect : {0.3, 1.0, 2.5}) {
      const PlacedCamera camera = place_camera({.automatic = view}, aspect, mesh);
      double reach = 0;
      for (int corner = 0; corner < 8; ++corner) {
        const glm::dvec3 low = mesh.to_internal(mesh.report.bounds.min),
                         high = mesh.to_internal(mesh.report.bounds.max);
        const glm::dvec3 c(corner & 1 ? high.x : low.x, corner & 2 ? high.y : low.y, corner & 4 ? high.z : low.z);
        const glm::dvec3 seen = c - camera.position;
        const double depth = glm::dot(seen, camera.forward) * camera.tan_half_fov;
        ASSERT_GT(depth, 0);
        reach = std::max({reach, std::abs(glm::dot(seen, camera.right)) / (depth * aspect),
                          std::abs(glm::dot(seen, camera.up)) / depth});
      }
      EXPECT_NEAR(reach, 0.92, 1e-9);
    }
  }
}

TEST_F(ResolveTest, CamerasAreRightHandedAndPixelsRunDown) {
  const PlacedCamera front = place_camera({.automatic = AutoView::front}, 1, sphere_.mesh());
  EXPECT_NEAR(glm::distance(front.right, glm::dvec3(1, 0, 0)), 0, 1e-12);
  EXPECT_NEAR(glm::distance(front.forward, glm::dvec3(0, 0, -1)), 0, 1e-12);
  EXPECT_LT(pixel_ray(front, {256, 400}, 512, 512).y, 0);
  EXPECT_GT(pixel_ray(front, {400, 256}, 512, 512).x, 0);
  EXPECT_NEAR(glm::distance(pixel_ray(front, {256, 256}, 512, 512), front.forward), 0, 1e-12);
  const Camera along_up{.automatic = AutoView::none, .position = {0, 5, 0}, .target = {0, 0, 0}, .up = {0, 1, 0}};
  const PlacedCamera top = place_camera(along_up, 1, sphere_.mesh());
  EXPECT_NEAR(glm::length(top.right), 1, 1e-12);
  EXPECT_NEAR(glm::dot(top.right, top.forward), 0, 1e-12);
}

}  // namespace
}  // namespace pelage
