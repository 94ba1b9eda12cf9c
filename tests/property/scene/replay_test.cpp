#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include "protocol/json/decode.h"
#include "protocol/json/encode.h"
#include "tests/property/scene/script.h"
#include "tests/unit/scene/store_fixture.h"

namespace pelage {
namespace {

std::string settings_text(const Scene& scene) {
  std::string text;
  const SnapshotPtr now = scene.snapshot();
  const SceneView view = now->view();
  text = encode(std::vector<Command>{SetCoat{view.settings.coats[0].coat}, SetLook{view.settings.look},
                                     SetLights{view.settings.lights}, SetEyes{view.settings.eyes},
                                     SetCurves{view.settings.curves}, SetSkin{view.settings.skin}});
  return text;
}

std::string lines_of(const std::vector<std::vector<Command>>& steps) {
  std::string text;
  for (const std::vector<Command>& step : steps) text += encode(step) + "\n";
  return text;
}

class ReplayTest : public StoreTest, public ::testing::WithParamInterface<std::uint64_t> {
 protected:
  void SetUp() override {
    folder_ = std::filesystem::path(::testing::TempDir()) / ("pelage_replay_" + std::to_string(GetParam()));
    std::filesystem::remove_all(folder_);
    open();
  }
};

// Replays an effective log, through JSON as a client would send it.
void replay(const std::vector<std::vector<Command>>& log, Scene& scene) {
  for (const std::vector<Command>& step : log) {
    const auto commands = decode_commands(encode(step));
    ASSERT_TRUE(commands.ok()) << commands.status().message << commands.status().pointer;
    const auto answer = scene.execute(*commands);
    ASSERT_TRUE(answer.ok()) << answer.status().message << answer.status().pointer;
  }
}

TEST_P(ReplayTest, AnyScriptReplaysUndoesAndSurvivesARestart) {
  const auto scene = make(Builtin::torus, 600);
  const FieldsHash first = hash(*scene);
  const std::string first_settings = settings_text(*scene);
  Script script(*scene, GetParam());
  while (scene->revision() < 260 && !HasFatalFailure()) script.act();

  const auto anew = make(Builtin::torus, 600);
  replay(scene->effective_log(), *anew);
  EXPECT_EQ(hash(*anew), hash(*scene));
  EXPECT_EQ(settings_text(*anew), settings_text(*scene));

  const SceneSummary before = scene->summary();
  const std::string log = encode(Log{scene->log()}), settings = settings_text(*scene);
  open();
  const auto restarted = *store_->find(before.id);
  const SceneSummary after = restarted->summary();
  EXPECT_EQ(after.revision, before.revision);
  EXPECT_EQ(after.fields_hash, before.fields_hash);
  EXPECT_EQ(after.undo_steps, before.undo_steps);
  EXPECT_EQ(after.redo_steps, before.redo_steps);
  EXPECT_EQ(encode(Log{restarted->log()}), log);
  EXPECT_EQ(settings_text(*restarted), settings);

  const int steps = static_cast<int>(after.undo_steps);
  ASSERT_GT(steps, 0);
  EXPECT_EQ(move(*restarted, Undo{steps}).fields_hash, first);
  EXPECT_EQ(settings_text(*restarted), first_settings);
  EXPECT_TRUE(restarted->effective_log().empty());
  EXPECT_EQ(move(*restarted, Redo{steps}).fields_hash, before.fields_hash);
  EXPECT_EQ(settings_text(*restarted), settings);
}

TEST_P(ReplayTest, AnyRevisionCanBeGoneBackTo) {
  const auto scene = make(Builtin::torus, 600);
  Script script(*scene, GetParam() + 1000);
  std::vector<std::pair<Revision, FieldsHash>> seen;
  while (scene->revision() < 60 && !HasFatalFailure()) {
    seen.emplace_back(scene->revision(), hash(*scene));
    script.act();
  }
  for (const auto& [revision, expected] : seen) {
    ASSERT_EQ(move(*scene, Revert{revision}).fields_hash, expected) << revision;
    if (revision % 7 != 0) continue;
    const auto anew = make(Builtin::torus, 600);
    replay(scene->effective_log(), *anew);
    ASSERT_EQ(hash(*anew), expected) << revision;
    ASSERT_TRUE(store_->remove(anew->id()).ok());
  }
}

/// Undoes every step and then redoes it. Returns the hash after each move.
std::vector<FieldsHash> hashes_of_undo_and_redo(Scene& scene) {
  std::vector<FieldsHash> hashes;
  const std::size_t steps = scene.summary().undo_steps;
  const auto go = [&](const HistoryMove& move) {
    const auto answer = scene.move(move);
    ASSERT_TRUE(answer.ok()) << answer.status().message;
    hashes.push_back(answer->fields_hash);
  };
  for (std::size_t i = 0; i < steps; ++i) go(Undo{});
  for (std::size_t i = 0; i < steps; ++i) go(Redo{});
  return hashes;
}

TEST_P(ReplayTest, StepsBeyondTheUndoMemoryComeBackFromTheJournal) {
  const auto run = [&](std::size_t undo_bytes) {
    open(undo_bytes);
    const auto scene = make(Builtin::torus, 600);
    const FieldsHash first = hash(*scene);
    Script script(*scene, GetParam() + 2000);
    while (scene->revision() < 100 && !HasFatalFailure()) script.act();
    const FieldsHash last = hash(*scene);
    std::vector<FieldsHash> hashes = hashes_of_undo_and_redo(*scene);
    const int steps = static_cast<int>(scene->summary().undo_steps);
    EXPECT_EQ(move(*scene, Undo{steps}).fields_hash, first);
    EXPECT_EQ(move(*scene, Redo{steps}).fields_hash, last);
    hashes.insert(hashes.end(), {first, last});
    return hashes;
  };
  const std::vector<FieldsHash> all_in_memory = run(limits::undo_bytes);
  EXPECT_EQ(run(0), all_in_memory);
  EXPECT_EQ(run(4000), all_in_memory) << "some steps in memory, some not";
}

// An amendment must have the same result as its edited list of steps, replayed into a fresh scene.
TEST_P(ReplayTest, AmendmentsAndBranchesAreWhatTheirListsSay) {
  open(4000);  // keeps only some steps in memory
  auto scene = make(Builtin::torus, 600);
  Script script(*scene, GetParam() + 3000, Script::Layers::none);
  std::vector<std::string> ids;
  for (int round = 0; round < 6 && !HasFatalFailure(); ++round) {
    for (int i = 0; i < 8; ++i) script.act();
    const SceneSummary before = scene->summary();
    const std::string settings = settings_text(*scene);
    const auto steps = script.amend();
    const auto anew = make(Builtin::torus, 600);
    replay(steps, *anew);
    ASSERT_EQ(hash(*scene), hash(*anew)) << round;
    ASSERT_EQ(settings_text(*scene), settings_text(*anew)) << round;
    ASSERT_EQ(lines_of(scene->effective_log()), lines_of(anew->effective_log())) << round;
    ASSERT_TRUE(store_->remove(anew->id()).ok());

    if (scene->revision() == before.revision) continue;  // there was nothing to amend
    const auto side = store_->branch(*scene, {});
    ASSERT_TRUE(side.ok());
    const FieldsHash amended = hash(*scene);
    ASSERT_EQ(move(**side, Undo{}).fields_hash, before.fields_hash) << round;
    ASSERT_EQ(settings_text(**side), settings) << round;
    ASSERT_EQ(move(**side, Redo{}).fields_hash, amended) << round;
    const auto back = store_->branch(*scene, {"back", before.revision});
    ASSERT_TRUE(back.ok());
    ASSERT_EQ(hash(**back), before.fields_hash) << round;
    ids.push_back((*side)->id()), ids.push_back((*back)->id());
  }
  EXPECT_GE(ids.size(), 6u) << "most rounds amend something";
  ids.push_back(scene->id());
  std::vector<std::pair<FieldsHash, std::string>> known;
  for (const std::string& id : ids)
    known.emplace_back(hash(**store_->find(id)), encode(Log{(*store_->find(id))->log()}));
  scene.reset();
  open();
  for (std::size_t i = 0; i < ids.size(); ++i) {
    const auto again = *store_->find(ids[i]);
    EXPECT_EQ(hash(*again), known[i].first);
    EXPECT_EQ(encode(Log{again->log()}), known[i].second);
  }
}

INSTANTIATE_TEST_SUITE_P(Seeds, ReplayTest, ::testing::Range<std::uint64_t>(1, 5));

}  // namespace
}  // namespace pelage
