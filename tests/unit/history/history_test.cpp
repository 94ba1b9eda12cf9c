#include "server/history/history.h"

#include <gtest/gtest.h>

#include <array>

#include "protocol/json/encode.h"
#include "server/fields/field_set.h"
#include "tests/unit/history/comb_strokes.h"

namespace pelage {
namespace {

double first_x(const Command& command) {
  return std::get<PositionSample>(stroke_of(command)->samples.front().position).position.x;
}

/// A history over one vertex, whose length shows which step is in effect.
class HistoryTest : public ::testing::Test {
 protected:
  FieldDelta to(float length) const {
    FieldSet from(1), after(1);
    from.set(0, {{}, length_, 0}), after.set(0, {{}, length, 0});
    return difference(from, after);
  }
  void take(EntryKind kind, std::uint64_t argument, std::string commands, FieldDelta delta,
            std::shared_ptr<const SceneSettings> settings = nullptr) {
    FieldSet fields(1);
    fields.set(0, {{}, length_, 0});
    fields.apply(delta);
    length_ = fields.at(0).length;
    const Entry entry{history_.revision() + 1, kind, argument, std::move(commands), std::move(delta), {}, settings};
    ASSERT_TRUE(history_.accepts(entry));
    history_.record(entry);
  }
  void step(float length) { take(EntryKind::command, 0, encode(Command(comb_at(length))), to(length)); }
  void undo(std::uint64_t steps) { take(EntryKind::undo, steps, "", *history_.undo(steps)); }
  void redo(std::uint64_t steps) { take(EntryKind::redo, steps, "", *history_.redo(steps)); }
  std::vector<double> effective() const {
    std::vector<double> found;
    for (const auto& commands : history_.effective_log()) found.push_back(first_x(commands.front()));
    return found;
  }

  History history_{5};
  float length_ = 0;
};

TEST_F(HistoryTest, EveryChangeTakesTheNextRevision) {
  EXPECT_EQ(history_.revision(), 5u);
  step(1);
  step(2);
  undo(2);
  redo(1);
  EXPECT_EQ(history_.revision(), 9u);
  EXPECT_EQ(length_, 1);
  EXPECT_EQ(history_.undo_steps(), 1u);
  EXPECT_EQ(history_.redo_steps(), 1u);
  EXPECT_EQ(effective(), (std::vector<double>{1}));
}

TEST_F(HistoryTest, MoreStepsThanThereAreAreRefused) {
  step(1);
  EXPECT_EQ(history_.undo(2).status().pointer, "/steps");
  EXPECT_EQ(history_.undo(2).status().limit, "at most 1");
  EXPECT_EQ(history_.redo(1).status().code, Code::invalid);
}

TEST_F(HistoryTest, ANewStepDropsWhatCouldBeRedoneFromTheListButNotFromTheLog) {
  step(1);
  step(2);
  undo(1);
  step(3);
  EXPECT_EQ(history_.redo_steps(), 0u);
  EXPECT_EQ(effective(), (std::vector<double>{1, 3}));
  const std::vector<LogEntry> log = history_.log();
  ASSERT_EQ(log.size(), 4u);
  EXPECT_EQ(log[2].kind, "undo");
  EXPECT_EQ(log[3].kind, "do");
  EXPECT_EQ(log[1].revision, 7u);
  EXPECT_EQ(log[1].touched, 1u);
}

TEST_F(HistoryTest, ARevertIsAStepThatCanBeUndone) {
  step(1);
  step(2);
  step(3);
  take(EntryKind::revert, 6, "", to(1));
  EXPECT_EQ(effective(), (std::vector<double>{1}));
  step(4);
  EXPECT_EQ(effective(), (std::vector<double>{1, 4}));
  undo(2);
  EXPECT_EQ(length_, 3);
  EXPECT_EQ(effective(), (std::vector<double>{1, 2, 3}));
  redo(1);
  EXPECT_EQ(effective(), (std::vector<double>{1}));
}

TEST_F(HistoryTest, ChangesSayWhatCouldBeUndoneAfterEach) {
  step(1);
  step(2);
  undo(2);
  redo(1);
  take(EntryKind::revert, 5, "", to(0));
  const std::vector<LoggedChange> all = history_.changes_after(5, 100);
  ASSERT_EQ(all.size(), 5u);
  const std::vector<std::array<std::size_t, 4>> expected{
      {6, 0, 1, 0}, {7, 0, 2, 0}, {8, 2, 0, 2}, {9, 1, 1, 1}, {10, 5, 2, 0}};
  for (std::size_t i = 0; i < all.size(); ++i) {
    const ChangeEvent& event = all[i].event;
    EXPECT_EQ((std::array<std::size_t, 4>{event.revision, event.argument, event.undo_steps, event.redo_steps}),
              expected[i]);
    EXPECT_EQ(event.kind, history_.log()[i].kind);
    EXPECT_EQ(all[i].commands, history_.log()[i].commands);
  }
  ASSERT_EQ(history_.changes_after(7, 2).size(), 2u);
  EXPECT_EQ(history_.changes_after(7, 2).front().event.revision, 8u);
  EXPECT_TRUE(history_.changes_after(10, 2).empty());
}

TEST_F(HistoryTest, SettingsGoWithTheSteps) {
  SceneSettings grey;
  grey.look.ambient = 2;
  take(EntryKind::command, 0, encode(Command(SetLook{grey.look})), {}, std::make_shared<const SceneSettings>(grey));
  step(1);
  EXPECT_EQ(history_.settings().look.ambient, 2);
  undo(2);
  EXPECT_EQ(history_.settings().look.ambient, Look{}.ambient);
  redo(2);
  EXPECT_EQ(history_.settings().look.ambient, 2);
}

TEST_F(HistoryTest, JoinedPartsAreOneStepAndOneWholeStroke) {
  step(1);
  take(EntryKind::command, 0, encode(Command(comb_at(2, "k", 0, false))), to(2));
  take(EntryKind::join, 0, encode(Command(comb_at(3, "k", 1, false))), to(3));
  take(EntryKind::join, 0, encode(Command(comb_at(4, "k", 2, true))), to(4));
  EXPECT_EQ(history_.undo_steps(), 2u);
  const auto steps = history_.effective_log();
  ASSERT_EQ(steps.size(), 2u);
  const Stroke& merged = *stroke_of(steps[1].front());
  EXPECT_EQ(merged.id, "");
  EXPECT_EQ(merged.part, 0u);
  EXPECT_TRUE(merged.last);
  ASSERT_EQ(merged.samples.size(), 6u);
  EXPECT_EQ(std::get<PositionSample>(merged.samples[4].position).position.x, 4);
  EXPECT_EQ(*history_.last_step(), to(1)) << "from the length before the stroke to the one after it, and back";
  undo(1);
  EXPECT_EQ(length_, 1);
  EXPECT_EQ(effective(), (std::vector<double>{1}));
}

TEST_F(HistoryTest, AnAmendmentIsOneStepOverAListOfReplayedOnes) {
  step(1);
  step(2);
  step(3);
  take(EntryKind::revert, 6, "", to(1));
  take(EntryKind::replay, 0, encode(Command(comb_at(20))), to(20));
  take(EntryKind::replay, 0, encode(Command(comb_at(3))), to(23));
  EXPECT_EQ(effective(), (std::vector<double>{1, 20, 3}));
  EXPECT_EQ(history_.undo_steps(), 4u);
  EXPECT_EQ(history_.log().back().kind, "replay");
  undo(1);
  EXPECT_EQ(length_, 3);
  EXPECT_EQ(effective(), (std::vector<double>{1, 2, 3}));
  redo(1);
  EXPECT_EQ(length_, 23);
  EXPECT_EQ(effective(), (std::vector<double>{1, 20, 3}));
  step(24);
  take(EntryKind::revert, 10, "", to(20));  // a second amendment: replayed steps are steps like any other
  take(EntryKind::replay, 0, encode(Command(comb_at(30))), to(30));
  EXPECT_EQ(effective(), (std::vector<double>{1, 20, 30}));
  undo(3);
  EXPECT_EQ(effective(), (std::vector<double>{1, 2, 3}));
}

TEST_F(HistoryTest, ListedStepsHaveTheirRevisions) {
  step(1);                                                                         // revision 6
  take(EntryKind::command, 0, encode(Command(comb_at(2, "k", 0, false))), to(2));  // 7
  take(EntryKind::join, 0, encode(Command(comb_at(3, "k", 1, true))), to(3));      // 8
  undo(1);
  redo(1);
  step(4);                                                         // 11
  take(EntryKind::revert, 6, "", to(1));                           // 12
  take(EntryKind::replay, 0, encode(Command(comb_at(5))), to(5));  // 13
  std::vector<Revision> marked;
  for (const LogEntry& line : history_.log()) {
    if (line.in_effect) marked.push_back(line.revision);
  }
  EXPECT_EQ(marked, (std::vector<Revision>{6, 13}));
  const auto revisions = [&] {
    std::vector<std::array<Revision, 3>> found;
    for (const ListedStep& one : history_.listed_steps()) found.push_back({one.before, one.first, one.last});
    return found;
  };
  EXPECT_EQ(revisions(), (std::vector<std::array<Revision, 3>>{{5, 6, 6}, {6, 13, 13}}));
  undo(1);
  EXPECT_EQ(revisions(), (std::vector<std::array<Revision, 3>>{{5, 6, 6}, {6, 7, 8}, {8, 11, 11}}));
}

TEST_F(HistoryTest, SettingsGoWithReplayedSteps) {
  SceneSettings grey;
  grey.look.ambient = 2;
  const auto settings = std::make_shared<const SceneSettings>(grey);
  step(1);
  take(EntryKind::revert, 5, "", to(0));
  take(EntryKind::replay, 0, encode(Command(SetLook{grey.look})), {}, settings);
  take(EntryKind::replay, 0, encode(Command(comb_at(1))), to(1));
  EXPECT_EQ(history_.settings().look.ambient, 2);
  undo(1);
  EXPECT_EQ(history_.settings().look.ambient, Look{}.ambient);
  redo(1);
  EXPECT_EQ(history_.settings().look.ambient, 2);
}

TEST_F(HistoryTest, RefusesEntriesThatCannotFollow) {
  step(1);
  EXPECT_FALSE(history_.accepts({7, EntryKind::replay, 0, "", {}, {}, {}})) << "nothing is gone back to";
  undo(1);
  history_ = History(5);
  length_ = 0;
  EXPECT_FALSE(history_.accepts({6, EntryKind::replay, 0, "", {}, {}, {}}));
  EXPECT_FALSE(history_.accepts({7, EntryKind::command, 0, "", {}, {}, {}}));
  EXPECT_FALSE(history_.accepts({6, EntryKind::undo, 1, "", {}, {}, {}}));
  EXPECT_FALSE(history_.accepts({6, EntryKind::join, 0, "", {}, {}, {}}));
  EXPECT_FALSE(history_.accepts({6, EntryKind::revert, 4, "", {}, {}, {}}));
  EXPECT_TRUE(history_.accepts({6, EntryKind::command, 0, "", {}, {}, {}}));
}

/// A history with a small memory budget; `journal_` holds every change.
class UndoMemoryTest : public ::testing::Test {
 protected:
  /// Changes many vertices, so that a step takes some memory.
  void step(float length) {
    FieldSet after = fields_;
    for (std::uint32_t v = 0; v < fields_.size(); ++v) after.set(v, {{}, length, 0});
    take({history_.revision() + 1,
          EntryKind::command,
          0,
          encode(Command(comb_at(length))),
          difference(fields_, after),
          {},
          {}});
  }
  void undo(std::uint64_t steps) {
    const Result<FieldDelta> delta = history_.undo(steps);
    ASSERT_TRUE(delta.ok());
    take({history_.revision() + 1, EntryKind::undo, steps, "", *delta, {}, {}});
  }
  void redo(std::uint64_t steps) {
    const Result<FieldDelta> delta = history_.redo(steps);
    ASSERT_TRUE(delta.ok());
    take({history_.revision() + 1, EntryKind::redo, steps, "", *delta, {}, {}});
  }
  void take(const Entry& entry) {
    fields_.apply(entry.delta);
    journal_.push_back(entry.delta);
    history_.record(entry);
    EXPECT_LE(history_.step_bytes(), budget);
  }
  Result<FieldDelta> read(Revision from, Revision to) {
    ++reads_;
    if (broken_) return failure(Code::internal, "the disk is gone");
    FieldDelta total;
    for (Revision r = from; r < to; ++r) total = compose(total, journal_[r]);
    return total;
  }
  float length() const { return fields_.at(7).length; }

  static constexpr std::size_t budget = 1200;  // steps take some 500 bytes
  FieldSet fields_{100};
  std::vector<FieldDelta> journal_;
  int reads_ = 0;
  bool broken_ = false;
  History history_{0, {}, {budget, [this](Revision from, Revision to) { return read(from, to); }}};
};

TEST_F(UndoMemoryTest, TheOldestStepsGiveWayAndAreReadBack) {
  for (int i = 1; i <= 5; ++i) step(static_cast<float>(i));
  undo(2);
  EXPECT_EQ(reads_, 0) << "the newest are in memory";
  EXPECT_EQ(length(), 3);
  undo(3);
  EXPECT_EQ(reads_, 3);
  EXPECT_EQ(length(), 0);
  redo(5);
  EXPECT_EQ(length(), 5);
  undo(4);
  step(9);
  EXPECT_EQ(history_.redo_steps(), 0u);
  undo(2);
  EXPECT_EQ(length(), 0);
}

TEST_F(UndoMemoryTest, AmendmentsCountAndAreReadBackWhole) {
  for (int i = 1; i <= 3; ++i) step(static_cast<float>(i));
  const auto go_on = [&](EntryKind kind, Revision argument, float length) {
    FieldSet after = fields_;
    for (std::uint32_t v = 0; v < fields_.size(); ++v) after.set(v, {{}, length, 0});
    const std::string text = encode(Command(comb_at(length)));
    take({history_.revision() + 1, kind, argument, text, difference(fields_, after), {}, {}});
  };
  go_on(EntryKind::revert, 1, 1);
  for (const float length : {20.0f, 30.0f, 40.0f}) go_on(EntryKind::replay, 0, length);
  EXPECT_EQ(history_.undo_steps(), 4u);
  for (int i = 5; i <= 8; ++i) step(static_cast<float>(i));  // the amendment is evicted
  undo(4);
  EXPECT_EQ(length(), 40);
  reads_ = 0;
  undo(1);
  EXPECT_EQ(length(), 3);
  EXPECT_EQ(reads_, 1);
  redo(1);
  EXPECT_EQ(length(), 40);
}

TEST_F(UndoMemoryTest, WhatCannotBeReadBackIsAFailureAndNotALoss) {
  for (int i = 1; i <= 5; ++i) step(static_cast<float>(i));
  broken_ = true;
  EXPECT_EQ(history_.undo(5).status().code, Code::internal);
  broken_ = false;
  undo(5);
  EXPECT_EQ(length(), 0);
}

}  // namespace
}  // namespace pelage
