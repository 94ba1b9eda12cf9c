#include "server/groom/standing_fur.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "server/groom/brush.h"
#include "tests/unit/groom/shapes.h"

namespace pelage {
namespace {

using testing_shapes::make_surface;
using testing_shapes::stroke_through;
using testing_shapes::vertex_towards;

constexpr double length = 0.2;  // in sizes; the sphere's radius is 0.2887

/// A ball with upright fur, except on its bald lower half.
class StandingFurTest : public ::testing::Test {
 protected:
  StandingFurTest() : fields_(static_cast<std::uint32_t>(sphere_.mesh().positions.size())) {
    for (std::uint32_t v = 0; v < fields_.size(); ++v) {
      const bool bald = sphere_.mesh().positions[v].y < 0;
      fields_.set(Field::length, v, glm::vec4(bald ? 0 : static_cast<float>(length)));
    }
  }
  bool reaches(const std::vector<StandingFur::Reached>& reached, std::uint32_t vertex) const {
    return std::any_of(reached.begin(), reached.end(), [&](const auto& one) { return one.vertex == vertex; });
  }

  Surface sphere_ = make_surface(Builtin::sphere, 2000);
  FieldSet fields_;
  Coat coat_;
  const std::uint32_t top_ = vertex_towards(sphere_, {0, 1, 0}), bottom_ = vertex_towards(sphere_, {0, -1, 0});
  const double radius_ = sphere_.mesh().positions[top_].y;
};

TEST_F(StandingFurTest, StrandsAreFoundByTheirTips) {
  const StandingFur fur(sphere_, fields_, coat_);
  const std::vector<StandingFur::Reached> reached = fur.within({0, radius_ + length, 0}, 0.02);
  ASSERT_TRUE(reaches(reached, top_));
  const auto top = std::find_if(reached.begin(), reached.end(), [&](const auto& one) { return one.vertex == top_; });
  EXPECT_NEAR(top->distance, 0, 1e-6);
  EXPECT_NEAR(top->lift, 1, 1e-6);
  EXPECT_TRUE(std::is_sorted(reached.begin(), reached.end(), [](auto a, auto b) { return a.vertex < b.vertex; }));
}

TEST_F(StandingFurTest, BaldVerticesAreReachedAtTheirRoots) {
  const StandingFur fur(sphere_, fields_, coat_);
  EXPECT_TRUE(reaches(fur.within({0, -radius_, 0}, 0.02), bottom_));
  EXPECT_FALSE(reaches(fur.within({0, -radius_ - length, 0}, 0.02), bottom_));
}

TEST_F(StandingFurTest, ARayHitsFurBeforeSkinAndBesideIt) {
  const StandingFur fur(sphere_, fields_, coat_);
  const double infinity = std::numeric_limits<double>::infinity();
  const auto onto_skin = fur.first_hit({{0, 0.1, 2}, {0, 0, -1}, infinity}, 0);
  ASSERT_TRUE(onto_skin.has_value());
  EXPECT_GT(onto_skin->z, radius_);
  const auto over_skin = fur.first_hit({{0, radius_ + 0.5 * length, 2}, {0, 0, -1}, infinity}, 0);
  ASSERT_TRUE(over_skin.has_value());
  EXPECT_NEAR(over_skin->z, 0, 0.3);
  EXPECT_NEAR(over_skin->y, radius_ + 0.5 * length, 1e-12);
  EXPECT_FALSE(fur.first_hit({{0, radius_ + 2 * length, 2}, {0, 0, -1}, infinity}, 0).has_value());
  EXPECT_TRUE(fur.first_hit({{0, radius_ + 1.3 * length, 2}, {0, 0, -1}, infinity}, 0.4 * length).has_value());
}

TEST_F(StandingFurTest, NothingIsHitBeyondTheRaysEndOrBehindIt) {
  const StandingFur fur(sphere_, fields_, coat_);
  const double y = radius_ + 0.5 * length;
  EXPECT_FALSE(fur.first_hit({{0, y, 2}, {0, 0, -1}, 1}, 0).has_value());
  EXPECT_FALSE(fur.first_hit({{0, y, 2}, {0, 0, 1}, 10}, 0).has_value());
}

TEST_F(StandingFurTest, BaldModelsHaveNothingToHit) {
  for (std::uint32_t v = 0; v < fields_.size(); ++v) fields_.set(Field::length, v, glm::vec4(0));
  const StandingFur fur(sphere_, fields_, coat_);
  EXPECT_EQ(fur.longest(), 0);
  EXPECT_FALSE(fur.first_hit({{0, 0.1, 2}, {0, 0, -1}, 10}, 1).has_value());
}

TEST_F(StandingFurTest, ABrushAtTheTipsReachesTheRootsOnlyWhereItReachesForFur) {
  const glm::dvec3 tip(0, radius_ + length, 0);
  Comb comb;
  comb.stroke = stroke_through(sphere_, {tip - glm::dvec3(0.02, 0, 0), tip + glm::dvec3(0.02, 0, 0)});
  comb.brush = {.radius = 0.03, .reach = Reach::fur, .strength = 1};
  const FieldDelta combed = evaluate(comb, sphere_, fields_).delta;
  const std::vector<std::uint32_t> turned = combed.vertices();
  EXPECT_TRUE(std::count(turned.begin(), turned.end(), top_));
  FieldSet after = fields_;
  after.apply(combed);
  EXPECT_GT(testing_shapes::lean_of(sphere_, after.at(top_), top_).x, 0.1);
  comb.brush.reach = Reach::skin;
  EXPECT_TRUE(evaluate(comb, sphere_, fields_).delta.empty());
}

// The tips of long fur on a crest are visible from a side that their roots do not face.
TEST_F(StandingFurTest, TipsAreReachedFromASideThatTheirRootsDoNotFace) {
  const glm::dvec3 up = glm::normalize(glm::dvec3(0, 1, -0.3));
  const std::uint32_t behind = vertex_towards(sphere_, up);
  const glm::dvec3 root(sphere_.mesh().positions[behind]);
  Stroke stroke;
  StrokeSample sample;
  sample.position = PositionSample{sphere_.mesh().to_model(root * (1 + length / radius_))};
  stroke.samples = {sample};
  stroke.view = View{.camera = {.automatic = AutoView::front}};
  const Brush brush{.radius = 0.05, .reach = Reach::fur, .front_faces_only = true};
  const StandingFur fur(sphere_, fields_, coat_);
  const BrushStroke painted(stroke, brush, sphere_, &fur);
  std::vector<VertexWeight> weights;
  painted.weigh(painted.covering_dabs().front(), weights);
  const auto reached = [&] {
    return std::any_of(weights.begin(), weights.end(), [&](const auto& one) { return one.vertex == behind; });
  };
  EXPECT_TRUE(reached());
  Dab at_root = painted.covering_dabs().front();
  at_root.centre = root;
  painted.weigh(at_root, weights);
  EXPECT_FALSE(reached());
}

}  // namespace
}  // namespace pelage
