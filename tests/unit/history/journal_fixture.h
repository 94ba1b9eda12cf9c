// A folder with a journal's file, and a scene and an entry to write to it.
#pragma once

#include <gtest/gtest.h>

#include <filesystem>
#include <memory>
#include <string>

#include "server/history/journal.h"
#include "server/history/sqlite.h"

namespace pelage::testing {

class JournalTest : public ::testing::Test {
 protected:
  void SetUp() override {
    const auto* test = ::testing::UnitTest::GetInstance()->current_test_info();
    folder_ = std::filesystem::path(::testing::TempDir()) / (std::string("pelage_journal_") + test->name());
    std::filesystem::remove_all(folder_);
    std::filesystem::create_directories(folder_);
    path_ = (folder_ / "pelage.sqlite").string();
  }
  void TearDown() override { std::filesystem::remove_all(folder_); }

  std::unique_ptr<Journal> open() const {
    auto journal = Journal::open(path_);
    EXPECT_TRUE(journal.ok()) << journal.status().message;
    return journal.ok() ? std::move(*journal) : nullptr;
  }
  Status refusal() const {
    const auto journal = Journal::open(path_);
    return journal.ok() ? Status{} : journal.status();
  }
  void execute(const char* sql) const {
    auto database = Database::open(path_);
    ASSERT_TRUE(database.ok());
    ASSERT_TRUE(database->execute(sql).ok());
  }

  /// Runs a query on the file and returns the first column of its first row.
  std::string answer(const char* question) const {
    auto database = Database::open(path_);
    Statement statement = database->prepare(question);
    EXPECT_TRUE(statement.step().ok());
    return statement.text_at(0);
  }

  static StoredScene scene(std::string id) {
    return {std::move(id),
            "fox \"1\"",
            {"obj", {Axis::plus_z, Axis::minus_x, true, 30, {2, 7}}, std::string("a\0b", 3), FurPatches::hard},
            3,
            {{{Field::length, {2}, {7}}}}};
  }
  static Entry entry(Revision revision) {
    return {revision, EntryKind::command, 0, "{}", {{{Field::mask, {7}, {9}}}}, {~0ull, 5}, nullptr};
  }

  std::filesystem::path folder_;
  std::string path_;
};

}  // namespace pelage::testing
