#include "protocol/json/encode.h"
#include "tests/unit/scene/store_fixture.h"

namespace pelage::amend_test {
namespace {

class AmendTest : public StoreTest {
 protected:
  CommandAnswer amend(Scene& scene, Revision revision, const std::vector<Command>& commands) const {
    const Result<CommandAnswer> answer = scene.amend({revision, commands});
    EXPECT_TRUE(answer.ok()) << answer.status().message << " " << answer.status().pointer;
    return answer.ok() ? *answer : CommandAnswer{};
  }
  /// Expects that the request is refused and changes nothing. Returns the refusal.
  Status refusal(Scene& scene, const AmendRequest& request, const ExecuteOptions& options = {}) const {
    const std::string log = encode(Log{scene.log()});
    const FieldsHash before = hash(scene);
    const Result<CommandAnswer> answer = scene.amend(request, options);
    EXPECT_EQ(encode(Log{scene.log()}), log);
    EXPECT_EQ(hash(scene), before);
    EXPECT_FALSE(answer.ok());
    return answer.ok() ? Status{} : answer.status();
  }
  /// The fields of a fresh scene after these steps.
  FieldsHash fresh(const std::vector<std::vector<Command>>& steps) const {
    const auto scene = make();
    for (const auto& step : steps) execute(*scene, step);
    return hash(*scene);
  }
  static std::vector<std::string> kinds(const Scene& scene) {
    std::vector<std::string> kinds;
    for (const LogEntry& entry : scene.log()) kinds.push_back(entry.kind);
    return kinds;
  }
  static Command stronger(Comb comb) {
    comb.brush.radius *= 2, comb.lean = 0.9;
    return comb;
  }
  static Command smooth() {
    Smooth smooth;
    smooth.passes = 3, smooth.flood = true;
    return smooth;
  }
};

TEST_F(AmendTest, GivesWhatTheEditedListGives) {
  const auto scene = make();
  const Comb first = comb_at(*scene, 5), second = comb_at(*scene, 7), third = comb_at(*scene, 50);
  for (const Command& command : {Command(first), Command(second), smooth(), Command(third)}) execute(*scene, {command});
  const FieldsHash before = hash(*scene);

  const CommandAnswer answer = amend(*scene, 2, {stronger(second)});
  EXPECT_EQ(answer.revision, 8u);
  ASSERT_EQ(answer.results.size(), 3u);
  EXPECT_EQ(answer.results[0].op, "comb");
  EXPECT_EQ(answer.results[1].op, "smooth");
  EXPECT_GT(answer.results[0].touched, 0u);
  const FieldsHash edited = fresh({{first}, {stronger(second)}, {smooth()}, {third}});
  EXPECT_EQ(answer.fields_hash, edited);
  EXPECT_NE(edited, before);
  EXPECT_EQ(kinds(*scene), (std::vector<std::string>{"do", "do", "do", "do", "revert", "replay", "replay", "replay"}));
  EXPECT_EQ(scene->effective_log().size(), 4u);
  EXPECT_EQ(scene->summary().undo_steps, 5u);

  EXPECT_EQ(move(*scene, Undo{}).fields_hash, before);
  EXPECT_EQ(scene->effective_log().size(), 4u);
  EXPECT_EQ(move(*scene, Redo{}).fields_hash, edited);
  EXPECT_EQ(encode(scene->effective_log()[1]), encode(std::vector{stronger(second)}));
}

TEST_F(AmendTest, LeavesAStepOutAndPutsSeveralCommandsInItsPlace) {
  const auto scene = make();
  const Comb first = comb_at(*scene, 5), second = comb_at(*scene, 7);
  execute(*scene, {first, smooth()});
  execute(*scene, {second});
  EXPECT_EQ(amend(*scene, 1, {}).fields_hash, fresh({{second}}));
  EXPECT_EQ(scene->effective_log().size(), 1u);
  EXPECT_EQ(amend(*scene, 4, {second, first, smooth()}).fields_hash, fresh({{second, first, smooth()}}));
  EXPECT_EQ(scene->effective_log().size(), 1u);
  EXPECT_EQ(amend(*scene, 6, {}).fields_hash, fresh({}));
  EXPECT_TRUE(scene->effective_log().empty());
}

TEST_F(AmendTest, SettingsAreReplayedToo) {
  const auto scene = make();
  SetCoat coat;
  coat.coat.root_share = 0.6;
  SetLook look;
  look.look.ambient = 2;
  execute(*scene, {coat});
  execute(*scene, {look});
  coat.coat.root_share = 0.4;
  amend(*scene, 1, {coat});
  const SnapshotPtr now = scene->snapshot();
  const SceneView view = now->view();
  EXPECT_EQ(view.settings.coats[0].coat.root_share, 0.4);
  EXPECT_EQ(view.settings.look.ambient, 2);
  move(*scene, Undo{});
  EXPECT_EQ(scene->snapshot()->settings->coats[0].coat.root_share, 0.6);
}

TEST_F(AmendTest, WhatChangesNothingAnyMoreMakesNoEntry) {
  const auto scene = make();
  SetLook look;
  look.look.ambient = 2;
  execute(*scene, {comb_at(*scene, 5)});
  execute(*scene, {look});
  amend(*scene, 1, {look});
  EXPECT_EQ(kinds(*scene), (std::vector<std::string>{"do", "do", "revert", "replay"}));
  amend(*scene, 4, {comb_nothing(*scene)});
  EXPECT_TRUE(scene->effective_log().empty());
}

TEST_F(AmendTest, AnyRevisionOfAJoinedStrokeNamesIt) {
  for (const Revision revision : {2u, 3u}) {
    const auto scene = make();
    const Comb first = comb_at(*scene, 5), other = comb_at(*scene, 30);
    execute(*scene, {first});
    Comb part = comb_at(*scene, 7);
    part.stroke->id = "pen", part.stroke->last = false;
    execute(*scene, {part});
    Comb next = part;
    next.stroke->part = 1;
    next.stroke->samples = stroke_at(*scene, 9).samples;
    execute(*scene, {next});
    ASSERT_EQ(kinds(*scene).back(), "join");
    EXPECT_EQ(amend(*scene, revision, {other}).fields_hash, fresh({{first}, {other}}));
    next.stroke->part = 2;
    EXPECT_EQ(scene->execute({next}).status().pointer, "/stroke/part") << "the stroke has ended";
  }
}

TEST_F(AmendTest, ALiveStrokeBehindItIsReplayedWholeAndEnds) {
  const auto scene = make();
  const Comb first = comb_at(*scene, 5);
  execute(*scene, {first});
  Comb part = comb_at(*scene, 7);
  part.stroke->id = "pen", part.stroke->last = false;
  execute(*scene, {part});
  Comb whole = part;
  whole.stroke->id.clear(), whole.stroke->last = true;
  EXPECT_EQ(amend(*scene, 1, {stronger(first)}).fields_hash, fresh({{stronger(first)}, {whole}}));
  part.stroke->part = 1;
  EXPECT_EQ(scene->execute({part}).status().code, Code::invalid);
}

TEST_F(AmendTest, OnlyStepsInEffectCanBeAmended) {
  const auto scene = make();
  for (const std::size_t vertex : {5, 50, 90}) execute(*scene, {comb_at(*scene, vertex)});
  move(*scene, Undo{1});
  for (const Revision revision : {0u, 3u, 4u, 5u, 1000u}) {
    const Status refused = refusal(*scene, {revision, {comb_at(*scene, 9)}});
    EXPECT_EQ(refused.code, Code::invalid) << revision;
    EXPECT_EQ(refused.pointer, "/revision") << revision;
  }
  move(*scene, Revert{1});
  EXPECT_EQ(refusal(*scene, {2, {}}).pointer, "/revision");
  amend(*scene, 1, {comb_at(*scene, 9)});
  EXPECT_TRUE(scene->amend({1, {comb_at(*scene, 50)}}).ok()) << "the number of the step stays";
}

TEST_F(AmendTest, CommandsThatCannotRunAreRefusedByTheirNumber) {
  const auto scene = make();
  execute(*scene, {comb_at(*scene, 5)});
  Blow blow;
  blow.blower = "gone";
  EXPECT_EQ(refusal(*scene, {1, {blow}}).pointer, "/commands/0/blower");
  EXPECT_EQ(refusal(*scene, {1, {comb_at(*scene, 7), blow}}).pointer, "/commands/1/blower");
  Comb part = comb_at(*scene, 5);
  part.stroke->id = "pen", part.stroke->last = false;
  EXPECT_EQ(refusal(*scene, {1, {part}}).pointer, "/commands/0/stroke/part");
}

TEST_F(AmendTest, ALaterStepThatCannotBeReplayedKeepsEverythingAsItIs) {
  const auto scene = make();
  Blow wind;
  wind.source = {0, 3, 0}, wind.direction = {0, -1, 0};
  execute(*scene, {SetBlowers{{NamedBlower{"fan", wind}}}});
  execute(*scene, {comb_at(*scene, 5)});
  Blow blow;
  blow.blower = "fan";
  execute(*scene, {blow});
  const Status refused = refusal(*scene, {1, {}});
  EXPECT_EQ(refused.code, Code::invalid);
  EXPECT_EQ(refused.pointer, "/commands");
  EXPECT_NE(refused.message.find("revision 3"), std::string::npos) << refused.message;
  EXPECT_NE(refused.message.find("blower"), std::string::npos) << refused.message;
  open();
  EXPECT_EQ((*store_->find(scene->id()))->revision(), 3u);
}

TEST_F(AmendTest, ABlowerThatIsMovedBlowsAnew) {
  const auto scene = make();
  Blow down;
  down.source = {0, 3, 0}, down.direction = {0, -1, 0};
  Blow side;
  side.source = {3, 0, 0}, side.direction = {-1, 0, 0};
  Blow blow;
  blow.blower = "fan";
  execute(*scene, {SetBlowers{{NamedBlower{"fan", down}}}});
  execute(*scene, {blow});
  const Command moved = SetBlowers{{NamedBlower{"fan", side}}};
  EXPECT_EQ(amend(*scene, 1, {moved}).fields_hash, fresh({{moved}, {blow}}));
}

TEST_F(AmendTest, ReplayedCheckpointsNameTheReplayedState) {
  const auto scene = make();
  const Comb first = comb_at(*scene, 5), second = comb_at(*scene, 50);
  Erase back;
  back.checkpoint = "combed", back.flood = true, back.brush.strength = 1;
  execute(*scene, {first});
  execute(*scene, {Checkpoint{"combed", {}}});
  execute(*scene, {second});
  execute(*scene, {back});
  EXPECT_EQ(hash(*scene), fresh({{first}}));
  EXPECT_EQ(amend(*scene, 1, {stronger(first)}).fields_hash, fresh({{stronger(first)}}));
  const SnapshotPtr now = scene->snapshot();
  const SceneView view = now->view();
  ASSERT_EQ(view.settings.checkpoints.size(), 1u);
  EXPECT_EQ(view.settings.checkpoints[0].revision, 7u);
  Erase explicit_one;
  explicit_one.revision = 1, explicit_one.flood = true, explicit_one.brush.strength = 1;
  execute(*scene, {explicit_one});
  EXPECT_EQ(hash(*scene), fresh({{first}})) << "a revision stays what it was";
}

TEST_F(AmendTest, ADryRunAndAnotherRevisionChangeNothing) {
  const auto scene = make();
  const Comb first = comb_at(*scene, 5);
  execute(*scene, {first});
  execute(*scene, {comb_at(*scene, 50)});
  const FieldsHash before = hash(*scene);
  const auto tried = scene->amend({1, {stronger(first)}}, {.dry_run = true});
  ASSERT_TRUE(tried.ok());
  EXPECT_EQ(tried->results.size(), 2u);
  EXPECT_EQ(tried->revision, 2u);
  EXPECT_EQ(hash(*scene), before);
  EXPECT_EQ(refusal(*scene, {1, {}}, {.if_match = 1}).code, Code::precondition);
  EXPECT_TRUE(scene->amend({1, {}}, {.if_match = 2}).ok());
}

TEST_F(AmendTest, ARestartHasTheAmendment) {
  const auto scene = make();
  const Comb first = comb_at(*scene, 5);
  execute(*scene, {first});
  execute(*scene, {comb_at(*scene, 6)});
  const FieldsHash before = hash(*scene);
  const FieldsHash after = amend(*scene, 1, {stronger(first)}).fields_hash;
  const std::string log = encode(Log{scene->log()}), id = scene->id();
  for (const std::size_t undo_bytes : {limits::undo_bytes, std::size_t{0}}) {
    open(undo_bytes);
    const auto again = *store_->find(id);
    EXPECT_EQ(hash(*again), after);
    EXPECT_EQ(encode(Log{again->log()}), log);
    EXPECT_EQ(again->effective_log().size(), 2u);
    EXPECT_EQ(again->summary().undo_steps, 3u);
  }
  const auto again = *store_->find(id);
  EXPECT_EQ(move(*again, Undo{}).fields_hash, before) << "read back from the journal";
  EXPECT_EQ(move(*again, Redo{}).fields_hash, after);
}

}  // namespace
}  // namespace pelage::amend_test
