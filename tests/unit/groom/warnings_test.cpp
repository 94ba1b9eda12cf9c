// Commands that are carried out but probably not meant, which give warnings.
#include "server/groom/evaluate.h"
#include "tests/unit/groom/shapes.h"

namespace pelage {
namespace {

TEST(Warnings, EyesThatDoNotTouchTheSkinAreNamed) {
  const Surface surface = testing_shapes::make_surface(Builtin::sphere, 2000);
  const Mesh& mesh = surface.mesh();
  const double ball = glm::length(glm::dvec3(mesh.positions[0]));
  const auto eye_at = [&](double share) {
    return Eye{.position = mesh.to_model({0, 0, share * ball}), .radius = 0.03};
  };
  EXPECT_TRUE(warnings_of(SetEyes{{eye_at(1.05), eye_at(0.95)}}, surface).empty());
  const std::vector<std::string> warnings = warnings_of(SetEyes{{eye_at(1), eye_at(1.3), eye_at(0.5)}}, surface);
  ASSERT_EQ(warnings.size(), 2u);
  EXPECT_EQ(warnings[0].substr(0, 5), "eye 2");
  EXPECT_EQ(warnings[1].substr(0, 5), "eye 3");
}

Comb comb_at(glm::dvec3 position) {
  Comb comb;
  comb.stroke.emplace();
  comb.stroke->samples = {{PositionSample{position}}, {PositionSample{position + glm::dvec3(0.1, 0, 0)}}};
  return comb;
}

TEST(Warnings, StrokesThatChangeNothingSaySo) {
  const std::vector<std::string> warnings = warnings_of_no_change(comb_at({100, 0, 0}));
  ASSERT_EQ(warnings.size(), 1u);
  EXPECT_NE(warnings[0].find("under the brush"), std::string::npos);
  EXPECT_TRUE(warnings_of_no_change(SetLights{}).empty());
  Comb part = comb_at({100, 0, 0});
  part.stroke->id = "live";
  EXPECT_TRUE(warnings_of_no_change(part).empty());
}

}  // namespace
}  // namespace pelage
