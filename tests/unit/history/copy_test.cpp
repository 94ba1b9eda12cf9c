// Copies of a scene into another journal: they are complete or nothing, and nobody waits for them.
#include <gtest/gtest.h>

#include <chrono>
#include <filesystem>
#include <future>
#include <memory>
#include <string>

#include "server/history/journal.h"

namespace pelage::copy_test {
namespace {

struct Stopped {};

class JournalCopyTest : public ::testing::Test {
 protected:
  static constexpr Revision first = 3, entries = 200;  // more entries than are read at a time

  void SetUp() override {
    const auto* test = ::testing::UnitTest::GetInstance()->current_test_info();
    folder_ = std::filesystem::path(::testing::TempDir()) / (std::string("pelage_copy_") + test->name());
    std::filesystem::remove_all(folder_);
    std::filesystem::create_directories(folder_);
    from_ = open("from"), to_ = open("to");
    ASSERT_TRUE(from_->add_scene(scene("a", first)).ok());
    for (Revision r = 1; r <= entries; ++r) ASSERT_TRUE(from_->append("a", entry(first + r)).ok());
  }
  void TearDown() override {
    from_.reset(), to_.reset();
    std::filesystem::remove_all(folder_);
  }

  std::unique_ptr<Journal> open(const char* name) const {
    auto journal = Journal::open((folder_ / name).string());
    EXPECT_TRUE(journal.ok()) << journal.status().message;
    return journal.ok() ? std::move(*journal) : nullptr;
  }
  static StoredScene scene(std::string id, Revision revision) {
    return {std::move(id), "fox", {"obj", {}, "raw", FurPatches::hard}, revision, {{{Field::length, {2}, {7}}}}};
  }
  static Entry entry(Revision revision) {
    return {revision, EntryKind::command, 0, "{}", {{{Field::mask, {7}, {9}}}}, {~0ull, 5}, nullptr};
  }
  /// Copies the scene, and calls `once` halfway through its entries.
  Result<Revision> copy(const std::function<void()>& once) const {
    return from_->copy_scene("a", newest_revision, *to_, "b", "cat", [&, count = 0]() mutable {
      if (++count == static_cast<int>(entries) / 2) once();
    });
  }

  std::filesystem::path folder_;
  std::unique_ptr<Journal> from_, to_;
};

TEST_F(JournalCopyTest, OthersWriteAndReadMeanwhile) {
  std::future<bool> others;  // outlives the copy, so that it can end even if it had to wait for the copy
  const Result<Revision> copied = copy([&] {
    others = std::async(std::launch::async, [&] {
      return from_->append("a", entry(first + entries + 1)).ok() && from_->add_scene(scene("other", 0)).ok() &&
             from_->entries("a", first)->size() == entries + 1;
    });
    EXPECT_EQ(others.wait_for(std::chrono::seconds(20)), std::future_status::ready) << "they wait for the copy";
  });
  EXPECT_TRUE(others.get());
  ASSERT_TRUE(copied.ok()) << copied.status().message;
  EXPECT_EQ(*copied, first + entries);  // the state when the copy began
  EXPECT_EQ(to_->scene("b")->name, "cat");
  const auto written = to_->entries("b", first);
  ASSERT_TRUE(written.ok());
  ASSERT_EQ(written->size(), entries);
  EXPECT_EQ(written->back().delta, entry(first + entries).delta);
}

TEST_F(JournalCopyTest, OneThatIsEndedLeavesNothing) {
  EXPECT_THROW(static_cast<void>(copy([] { throw Stopped{}; })), Stopped);
  EXPECT_TRUE(to_->scene_ids()->empty());
  EXPECT_TRUE(copy([] {}).ok()) << "the journal takes another one";
}

TEST_F(JournalCopyTest, OneWhoseSceneGetsAnotherModelIsRefusedAndLeavesNothing) {
  const Result<Revision> copied =
      copy([&] { ASSERT_TRUE(from_->replace_model(scene("a", first + entries + 1)).ok()); });
  EXPECT_EQ(copied.status().code, Code::conflict);
  EXPECT_TRUE(to_->scene_ids()->empty());
}

}  // namespace
}  // namespace pelage::copy_test
