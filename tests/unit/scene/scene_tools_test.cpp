// Tools that need a scene: checkpoints, persistent blowers and attractors, symmetry, differences of revisions.
#include "server/scene/scene.h"
#include "tests/unit/scene/store_fixture.h"

namespace pelage::scene_tools_test {
namespace {

class SceneToolsTest : public StoreTest {
 protected:
  static Status refusal(Scene& scene, const std::vector<Command>& commands) {
    const auto answer = scene.execute(commands);
    return answer.ok() ? Status{} : answer.status();
  }
  static Erase erase_all() {
    Erase erase;
    erase.flood = true;
    erase.brush.strength = 1;
    return erase;
  }
};

TEST_F(SceneToolsTest, EraseGoesBackToTheFirstGroomACheckpointOrARevision) {
  const auto scene = make();
  const FieldsHash first = hash(*scene);
  const FieldsHash combed = execute(*scene, {comb_at(*scene, 5), Checkpoint{"combed", {}}}).fields_hash;
  execute(*scene, {comb_at(*scene, 90)});
  Erase erase = erase_all();
  erase.checkpoint = "combed";
  EXPECT_EQ(execute(*scene, {erase}).fields_hash, combed);
  EXPECT_EQ(execute(*scene, {erase_all()}).fields_hash, first);
  erase.checkpoint.clear(), erase.revision = 1;
  EXPECT_EQ(execute(*scene, {erase}).fields_hash, combed);
  move(*scene, Undo{1});
  EXPECT_EQ(hash(*scene), first);
  const std::string id = scene->id();
  open();
  EXPECT_EQ(hash(**store_->find(id)), first) << "a restart knows it too";
}

TEST_F(SceneToolsTest, WhatErasesAndNamesNameHasToBeThere) {
  const auto scene = make();
  Erase erase = erase_all();
  erase.checkpoint = "none";
  EXPECT_EQ(refusal(*scene, {erase}).pointer, "/checkpoint");
  erase.checkpoint.clear(), erase.revision = 7;
  EXPECT_EQ(refusal(*scene, {erase}).pointer, "/revision");
  EXPECT_EQ(refusal(*scene, {Checkpoint{"later", 7}}).pointer, "/revision");
  EXPECT_EQ(refusal(*scene, {Blow{.blower = "fan"}}).pointer, "/blower");
  EXPECT_EQ(refusal(*scene, {Attract{.attractor = "stick"}}).pointer, "/attractor");
  EXPECT_EQ(scene->revision(), 0u);
}

TEST_F(SceneToolsTest, AWindThatStaysBlowsAsOneThatIsWrittenOut) {
  const auto named = make(), written = make();
  Blow wind;
  wind.source = vertex_position(*named, 3) + glm::dvec3(0, 1, 0);
  wind.cone_degrees = 60, wind.fall = 0.4, wind.lean = 0.9;
  execute(*named, {SetBlowers{{{"fan", wind}}}});
  EXPECT_EQ(execute(*named, {Blow{.blower = "fan"}}).fields_hash, execute(*written, {wind}).fields_hash);
  EXPECT_TRUE(refusal(*named, {SetBlowers{{{"gust", wind}}}, Blow{.blower = "gust"}}).ok());
  EXPECT_EQ(refusal(*named, {Blow{.blower = "fan"}}).pointer, "/blower") << "the list was replaced";
}

TEST_F(SceneToolsTest, AnAttractorThatStaysPullsAsOneThatIsWrittenOut) {
  const auto named = make(), written = make();
  Attract stick;
  stick.point = vertex_position(*named, 3) * 1.2;
  execute(*named, {SetAttractors{{{"stick", stick}}}});
  EXPECT_EQ(execute(*named, {Attract{.attractor = "stick"}}).fields_hash, execute(*written, {stick}).fields_hash);
}

TEST_F(SceneToolsTest, AMirroredStrokeIsOneStepAndWhatBothStrokesGive) {
  const auto symmetric = make(Builtin::sphere), both = make(Builtin::sphere);
  SetSymmetry mirror;
  mirror.symmetry.planes = {{}};
  execute(*symmetric, {mirror});
  Comb comb;
  comb.stroke.emplace();
  for (const double y : {0.2, 0.5}) {
    StrokeSample sample;
    sample.position = PositionSample{{0.7, y, 0.5}};
    comb.stroke->samples.push_back(sample);
  }
  comb.brush.radius = 0.1;
  Comb twin = comb;
  for (StrokeSample& sample : twin.stroke->samples) std::get<PositionSample>(sample.position).position.x = -0.7;
  const CommandAnswer once = execute(*symmetric, {comb});
  EXPECT_EQ(once.fields_hash, execute(*both, {comb, twin}).fields_hash);
  EXPECT_EQ(once.results.size(), 1u);
  EXPECT_EQ(symmetric->summary().undo_steps, 2u);
}

TEST_F(SceneToolsTest, ComparisonsMeasureTheDifference) {
  const auto scene = make();
  const CommandAnswer combed = execute(*scene, {comb_at(*scene, 5)});
  Paint paint;
  paint.flood = true, paint.field = Field::wetness, paint.brush.strength = 0.5;
  execute(*scene, {paint});
  const auto both = scene->compare(0, 2);
  ASSERT_TRUE(both.ok());
  ASSERT_EQ(both->fields.size(), 2u);
  EXPECT_EQ(both->fields[0].field, "direction");
  EXPECT_EQ(both->fields[0].max_change, combed.results[0].max_change);
  EXPECT_EQ(both->fields[1].field, "wetness");
  EXPECT_EQ(both->fields[1].mean_change, 0.5);
  EXPECT_EQ(both->touched, scene->summary().report.vertices);
  EXPECT_TRUE(scene->compare(2, 2)->fields.empty());
  EXPECT_EQ(scene->compare(0, 1)->touched, combed.results[0].touched);
  EXPECT_EQ(scene->compare(3, 1).status().pointer, "/from");
  EXPECT_EQ(scene->compare(1, 3).status().pointer, "/to");
}

}  // namespace
}  // namespace pelage::scene_tools_test
