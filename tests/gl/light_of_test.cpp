// What a frame does not need is not compiled; what it needs is.
#include <gtest/gtest.h>

#include "renderer/frame/parts.h"

namespace pelage::light_of_test {
namespace {

bool names(const FurFrame& frame, const char* define, bool model_has_colours = true) {
  return light_of(frame, model_has_colours).find(define) != std::string::npos;
}

TEST(LightOf, NamesTheLightsAndWhetherAllAreFarAway) {
  FurFrame frame;
  frame.lights = {{.kind = LightKind::directional}, {.kind = LightKind::directional}};
  EXPECT_TRUE(names(frame, "LIGHTS 2"));
  EXPECT_TRUE(names(frame, "FAR_LIGHTS"));
  for (const LightKind kind : {LightKind::point, LightKind::spot, LightKind::area}) {
    frame.lights[1].kind = kind;
    EXPECT_FALSE(names(frame, "FAR_LIGHTS"));
  }
}

TEST(LightOf, NamesSurroundingsThatAreNotWhiteFromEverywhere) {
  FurFrame frame;
  EXPECT_FALSE(names(frame, "ENVIRONMENT"));
  frame.environment.ground = {0.3f, 0.1f, 0};
  EXPECT_TRUE(names(frame, "ENVIRONMENT"));
}

TEST(LightOf, NamesFurThatTakesNoColoursOfTheModel) {
  FurFrame frame;
  EXPECT_FALSE(names(frame, "RAMP_COLOURS"));
  EXPECT_TRUE(names(frame, "RAMP_COLOURS", false));
  frame.look.colour_source = ColourSource::coat;
  EXPECT_TRUE(names(frame, "RAMP_COLOURS"));
  frame.look.colour_source = ColourSource::model;
  EXPECT_FALSE(names(frame, "RAMP_COLOURS", false));
}

}  // namespace
}  // namespace pelage::light_of_test
