// The commands that set the settings accept what GET settings answers.
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <nlohmann/json.hpp>

#include "protocol/json/decode.h"
#include "protocol/json/encode.h"
#include "tests/property/json/generators.h"
#include "tests/unit/scene/store_fixture.h"

namespace pelage {
namespace {

using SettingsTest = StoreTest;
using nlohmann::json;

struct Setter {
  const char *member, *op, *name;  // member of the settings, the command that sets it, and the command's member for it
};
constexpr Setter setters[] = {{"coats", "set_coats", "coats"},
                              {"look", "set_look", "look"},
                              {"lights", "set_lights", "lights"},
                              {"environment", "set_environment", "environment"},
                              {"ground", "set_ground", "ground"},
                              {"wind", "set_wind", "wind"},
                              {"eyes", "set_eyes", "eyes"},
                              {"curves", "set_curves", "groups"},
                              {"skin", "set_skin", "regions"},
                              {"skin_texture", "set_skin_texture", "picture"},
                              {"blowers", "set_blowers", "blowers"},
                              {"attractors", "set_attractors", "attractors"},
                              {"symmetry", "set_symmetry", "symmetry"}};

bool is_setting(const Command& command) {
  return std::visit([]<class C>(const C&) { return SettingCommand<C> && !std::is_same_v<C, ChangeEditLayer>; },
                    command);
}

/// Executes the settings among random commands; those with positions far away are refused.
void set_at_random(Scene& scene) {
  for (int i = *rc::gen::inRange(0, 12); i > 0; --i) {
    const Command command = testing::command();
    if (is_setting(command)) (void)scene.execute({command});
  }
}

/// Settings with random positions near the model.
std::vector<Command> placed_settings() {
  const auto near = [] { return glm::dvec3(testing::number(-1, 1), testing::number(-1, 1), testing::number(-1, 1)); };
  Eye eye;
  eye.position = near(), eye.radius = testing::number(0.001, 1), eye.gaze = testing::direction();
  NamedBlower fan{.name = "fan", .blow = {}};
  fan.blow.source = near(), fan.blow.direction = testing::direction();
  NamedAttractor stick{.name = "stick", .attract = {}};
  stick.attract.point = near(), stick.attract.radius = testing::number(0.001, 1);
  CurveGroup group;
  group.curves = {{near(), near() + 3.0}};
  SkinRegion region;
  region.centre = near(), region.axis = testing::direction();
  return {SetEyes{{eye}},         SetBlowers{{fan}},
          SetAttractors{{stick}}, SetCurves{{group}},
          SetSkin{{region}},      SetSymmetry{{.planes = {{near(), testing::direction()}}, .count = 3}},
          Checkpoint{"here", {}}};
}

TEST_F(SettingsTest, SentBackTheyChangeNothing) {
  const auto scene = make(Builtin::creature, 500);
  const bool held = rc::check([&] {
    set_at_random(*scene);
    for (const Command& command : placed_settings()) {
      if (*rc::gen::arbitrary<bool>()) RC_ASSERT(scene->execute({command}).ok());
    }
    const auto settings = scene->settings();
    RC_ASSERT(settings.ok());
    const json document = json::parse(encode(*settings));
    RC_ASSERT(document.size() == std::size(setters) + 3);  // plus revision, checkpoints, edit_layers
    for (const Setter& setter : setters) {
      const json body = {{"op", setter.op}, {setter.name, document.at(setter.member)}};
      const auto commands = decode_commands(body.dump());
      if (!commands.ok()) RC_FAIL(commands.status().message + " " + commands.status().pointer + " " + body.dump());
      const auto answer = scene->execute(*commands);
      if (!answer.ok()) RC_FAIL(answer.status().message + " " + answer.status().pointer + " " + body.dump());
      RC_ASSERT(answer->results.at(0).touched == 0u);
      if (answer->revision != settings->revision) RC_FAIL("changed by " + body.dump());
    }
  });
  EXPECT_TRUE(held);
}

TEST_F(SettingsTest, AreThoseOfTheAskedRevision) {
  const auto scene = make(Builtin::creature, 500);
  const std::string first = encode(*scene->settings());
  execute(*scene, {SetEyes{}});
  execute(*scene, {Checkpoint{"eyeless", {}}});
  EXPECT_EQ(encode(*scene->settings(0)), first);
  EXPECT_TRUE(scene->settings(1)->settings.eyes.empty());
  ASSERT_EQ(scene->settings()->settings.checkpoints.size(), 1u);
  EXPECT_EQ(scene->settings()->settings.checkpoints[0].revision, 2u);
  EXPECT_TRUE(scene->settings(1)->settings.checkpoints.empty());
  const Status late = scene->settings(3).status();
  EXPECT_EQ(late.code, Code::invalid);
  EXPECT_EQ(late.pointer, "/revision");
}

}  // namespace
}  // namespace pelage
