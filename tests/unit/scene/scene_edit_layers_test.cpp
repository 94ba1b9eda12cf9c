// Edit layers in a scene: target of a command, undo, the log, live strokes, symmetry, erase.
#include "server/scene/scene.h"
#include "tests/unit/scene/store_fixture.h"

namespace pelage::scene_edit_layers_test {
namespace {

class SceneEditLayersTest : public StoreTest {
 protected:
  static ChangeEditLayer add(const std::string& name) {
    ChangeEditLayer command;
    command.name = name;
    return command;
  }
  static ChangeEditLayer set(const std::string& name, std::optional<double> weight, std::optional<bool> muted = {}) {
    ChangeEditLayer command;
    command.action = EditLayerAction::set, command.name = name, command.weight = weight, command.muted = muted;
    return command;
  }
  static Comb comb_in(const Scene& scene, std::size_t vertex, const std::string& layer) {
    Comb comb = comb_at(scene, vertex);
    comb.edit_layer = layer;
    return comb;
  }
  /// The largest difference of a resulting field between two scenes, in the field's unit.
  static double distance(const Scene& a, const Scene& b, Field field) {
    double largest = 0;
    const auto one = a.snapshot()->fields, two = b.snapshot()->fields;
    for (std::uint32_t v = 0; v < one->size(); ++v)
      largest = std::max(largest, double{glm::distance(one->value(field, v), two->value(field, v))});
    return largest;
  }
};

TEST_F(SceneEditLayersTest, AStrokeInALayerIsSeenAsOneInTheGroom) {
  const auto plain = make(), layered = make();
  const FieldsHash first = hash(*layered);
  execute(*layered, {add("comb")});
  for (const std::size_t v : {5u, 60u, 61u}) {
    execute(*plain, {comb_at(*plain, v)});
    execute(*layered, {comb_in(*layered, v, "comb")});
  }
  EXPECT_LT(distance(*plain, *layered, Field::direction), 1e-6);
  EXPECT_GT(distance(*plain, *make(), Field::direction), 0.1);
  const FieldsHash combed = hash(*layered);
  execute(*layered, {set("comb", {}, true)});
  EXPECT_EQ(distance(*layered, *make(), Field::direction), 0) << "muted";
  move(*layered, Undo{1});
  EXPECT_EQ(hash(*layered), combed);
  move(*layered, Undo{4});
  EXPECT_EQ(hash(*layered), first);
  EXPECT_TRUE(layered->summary().edit_layers.empty());
  move(*layered, Redo{4});
  EXPECT_EQ(hash(*layered), combed);
}

TEST_F(SceneEditLayersTest, TheLogSaysWhichLayerACommandWentToAndReplays) {
  const auto scene = make(), replayed = make();
  execute(*scene, {add("a"), add("b")});
  execute(*scene, {comb_in(*scene, 5, "a"), comb_in(*scene, 9, "b"), set("a", -0.5)});
  execute(*scene, {comb_at(*scene, 7)});
  EXPECT_NE(scene->log()[1].commands.find("\"edit_layer\":\"a\""), std::string::npos);
  for (const std::vector<Command>& step : scene->effective_log()) execute(*replayed, step);
  EXPECT_EQ(hash(*replayed), hash(*scene));
  const FieldsHash before = hash(*scene);
  const std::string id = scene->id();
  open();
  EXPECT_EQ(hash(**store_->find(id)), before) << "a restart knows the edit layers' contents";
  ASSERT_EQ((*store_->find(id))->summary().edit_layers.size(), 2u);
  EXPECT_EQ((*store_->find(id))->summary().edit_layers[0].weight, -0.5);
  move(**store_->find(id), Revert{0});
  EXPECT_TRUE((*store_->find(id))->summary().edit_layers.empty());
}

TEST_F(SceneEditLayersTest, PartsOfALiveStrokeInALayerGiveWhatTheWholeGives) {
  const auto live = make(), whole = make();
  execute(*live, {add("a")});
  execute(*whole, {add("a")});
  const Comb comb = comb_in(*whole, 5, "a");
  execute(*whole, {comb});
  for (std::uint32_t part = 0; part < comb.stroke->samples.size(); ++part) {
    Comb part_command = comb;
    part_command.stroke->id = "s", part_command.stroke->part = part,
    part_command.stroke->last = part + 1 == comb.stroke->samples.size();
    part_command.stroke->samples = {comb.stroke->samples[part]};
    execute(*live, {part_command});
  }
  EXPECT_EQ(hash(*live), hash(*whole));
  EXPECT_EQ(live->summary().undo_steps, 2u);
}

TEST_F(SceneEditLayersTest, EraseTakesAwayWhatALayerAdds) {
  const auto scene = make();
  execute(*scene, {add("a"), add("b")});
  execute(*scene, {comb_in(*scene, 5, "a")});
  const FieldsHash before = hash(*scene);
  execute(*scene, {set("b", 0.4)});
  execute(*scene, {comb_in(*scene, 6, "b")});
  Erase erase;
  erase.flood = true, erase.brush.strength = 1, erase.edit_layer = "b";
  execute(*scene, {erase});
  EXPECT_EQ(hash(*scene), before) << "a is as it was, and b holds nothing";
}

TEST_F(SceneEditLayersTest, AWindThatStaysBlowsIntoTheLayerThatIsNamed) {
  const auto scene = make();
  Blow wind;
  wind.source = vertex_position(*scene, 3) + glm::dvec3(0, 1, 0);
  wind.cone_degrees = 60;
  execute(*scene, {add("a"), SetBlowers{{{"fan", wind}}}});
  Blow blow;
  blow.blower = "fan", blow.edit_layer = "a";
  EXPECT_GT(execute(*scene, {blow}).results[0].touched, 0u);
  execute(*scene, {set("a", {}, true)});
  EXPECT_EQ(distance(*scene, *make(), Field::direction), 0);
}

TEST_F(SceneEditLayersTest, RefusesAndChangesNothing) {
  const auto scene = make();
  execute(*scene, {add("a"), set("a", 0.01)});
  const auto pointer = [&](const std::vector<Command>& commands) {
    const auto answer = scene->execute(commands);
    return answer.ok() ? std::string("accepted") : answer.status().pointer;
  };
  EXPECT_EQ(pointer({comb_in(*scene, 5, "a")}), "/edit_layer");
  EXPECT_EQ(pointer({comb_in(*scene, 5, "none")}), "/edit_layer");
  EXPECT_EQ(pointer({add("b"), comb_in(*scene, 5, "c")}), "/commands/1/edit_layer");
  EXPECT_EQ(pointer({add("b"), add("b")}), "/commands/1/name");
  EXPECT_EQ(scene->revision(), 1u);
  EXPECT_EQ(pointer({add("b"), comb_in(*scene, 5, "b")}), "accepted") << "made by the command before it";
}

TEST_F(SceneEditLayersTest, AnAmendedStepStaysInItsLayer) {
  const auto amended = make(), fresh = make();
  execute(*amended, {add("a")});
  execute(*amended, {comb_in(*amended, 5, "a")});
  execute(*amended, {set("a", 0.5)});
  ASSERT_TRUE(amended->amend({2, {comb_in(*amended, 60, "a")}}).ok());
  execute(*fresh, {add("a")});
  execute(*fresh, {comb_in(*fresh, 60, "a")});
  execute(*fresh, {set("a", 0.5)});
  EXPECT_EQ(hash(*amended), hash(*fresh));
  const SceneSummary before = amended->summary();
  const auto dropped = amended->amend({1, {}});
  ASSERT_FALSE(dropped.ok()) << "a later step names the edit layer";
  EXPECT_NE(dropped.status().message.find("no edit layer of this name"), std::string::npos);
  EXPECT_EQ(amended->summary().revision, before.revision);
  EXPECT_EQ(hash(*amended), before.fields_hash);
}

TEST_F(SceneEditLayersTest, LayersGoAlongToFinerTriangles) {
  const auto scene = make(Builtin::torus, 500);
  execute(*scene, {add("a"), comb_in(*scene, 5, "a"), set("a", -0.5)});
  ASSERT_TRUE(store_->subdivide(*scene, {}).ok());
  const FieldsHash seen = hash(*scene);
  ASSERT_EQ(scene->summary().edit_layers.size(), 1u);
  execute(*scene, {set("a", {}, true)});
  EXPECT_NE(hash(*scene), seen) << "the edit layer's contents came along";
  const auto plain = make(Builtin::torus, 500);
  ASSERT_TRUE(store_->subdivide(*plain, {}).ok());
  EXPECT_EQ(distance(*scene, *plain, Field::direction), 0) << "and so did the groom below it";
  const std::string id = scene->id();
  const FieldsHash muted = hash(*scene);
  open();
  EXPECT_EQ(hash(**store_->find(id)), muted);
}

TEST_F(SceneEditLayersTest, ABrushFinerThanTheMeshIsWarnedOf) {
  const auto scene = make();
  Comb fine = comb_at(*scene, 5), coarse = fine;
  fine.brush.radius = 0.002, coarse.brush.radius = 0.2;
  const CommandAnswer warned = execute(*scene, {fine}), quiet = execute(*scene, {coarse});
  ASSERT_EQ(warned.results[0].warnings.size(), 1u);
  EXPECT_NE(warned.results[0].warnings[0].find("finer than the mesh"), std::string::npos);
  EXPECT_TRUE(quiet.results[0].warnings.empty());
}

}  // namespace
}  // namespace pelage::scene_edit_layers_test
