// Converts an untrusted database file to rows, and rows back to a journal.
#include "server/history/foreign_rows.h"

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <random>

#include "server/history/journal.h"
#include "server/history/sqlite.h"

namespace pelage::foreign_rows_test {
namespace {

class ForeignRows : public ::testing::Test {
 protected:
  void SetUp() override {
    const auto* test = ::testing::UnitTest::GetInstance()->current_test_info();
    folder_ = std::filesystem::path(::testing::TempDir()) / (std::string("pelage_rows_") + test->name());
    std::filesystem::remove_all(folder_);
    std::filesystem::create_directories(folder_);
    const auto journal = Journal::open(path("file"));
    ASSERT_TRUE(journal.ok() && (*journal)->add_scene(scene_).ok());
    ASSERT_TRUE((*journal)->add_picture("picture", std::string(10'000, 'p')).ok());
    for (Revision revision = 4; revision < 40; ++revision)
      ASSERT_TRUE((*journal)->append("a", {revision, EntryKind::command, 0, "[]", {}, {~0ull, 5}, nullptr}).ok());
  }
  void TearDown() override { std::filesystem::remove_all(folder_); }

  std::string path(const std::string& name) const { return (folder_ / name).string(); }
  std::string bytes() const {
    std::ifstream file(path("file"), std::ios::binary);
    return std::string(std::istreambuf_iterator<char>(file), {});
  }
  std::string rows() const {
    const Result<std::string> rows = foreign_rows(bytes());
    EXPECT_TRUE(rows.ok()) << rows.status().message;
    return rows ? *rows : "";
  }
  /// Makes a journal from the rows, passed on in chunks of `chunk_bytes` bytes.
  Result<std::unique_ptr<Journal>> journal_of(const std::string& rows, std::size_t chunk_bytes) const {
    std::filesystem::remove(path("rows"));
    return Journal::from_rows(path("rows"), [&](const Journal::TakeRows& take) {
      Status taken;
      for (std::size_t at = 0; at < rows.size() && taken.ok(); at += chunk_bytes)
        taken = take({rows.data() + at, std::min(chunk_bytes, rows.size() - at)});
      return taken;
    });
  }
  void execute(const char* sql) const {
    auto database = Database::open(path("file"));
    ASSERT_TRUE(database.ok());
    const Status done = database->execute(sql);
    ASSERT_TRUE(done.ok()) << done.message;
  }

  StoredScene scene_{"a",
                     "fox \"1\"",
                     {"obj", {Axis::plus_z, Axis::minus_x, true, 30, {2, 7}}, std::string("a\0b", 3), FurPatches::hard},
                     3,
                     {{{Field::length, {2}, {7}}}}};
  std::filesystem::path folder_;
};

TEST_F(ForeignRows, BecomeTheSameJournalInChunksOfAnySize) {
  for (const std::size_t chunk_bytes : {1u, 7u, 65536u}) {
    const auto journal = journal_of(rows(), chunk_bytes);
    ASSERT_TRUE(journal.ok()) << journal.status().message;
    const auto scene = (*journal)->scene("a");
    ASSERT_TRUE(scene.ok()) << scene.status().message;
    EXPECT_EQ(scene->name, scene_.name);
    EXPECT_EQ(scene->model.raw, scene_.model.raw);
    EXPECT_EQ(scene->first_groom, scene_.first_groom);
    const auto entries = (*journal)->entries("a", 0);
    ASSERT_TRUE(entries.ok()) << entries.status().message;
    ASSERT_EQ(entries->size(), 36u);
    EXPECT_EQ(entries->back().fields_hash, (FieldsHash{~0ull, 5}));
  }
}

TEST_F(ForeignRows, ThatAreCutOffOrDamagedAreRefused) {
  const std::string good = rows();
  EXPECT_EQ(journal_of(good.substr(0, good.size() - 1), 4096).status().code, Code::invalid);
  EXPECT_EQ(journal_of(good + good, 4096).status().code, Code::invalid) << "a scene of that id is there";
  EXPECT_EQ(journal_of(std::string(1, '\x7f') + good, 4096).status().code, Code::invalid) << "no such table";
  std::mt19937 random(5);
  for (int k = 0; k < 200; ++k) {
    std::string bad = good;
    bad[random() % bad.size()] ^= static_cast<char>(1u << random() % 8);
    const auto journal = journal_of(bad, 4096);
    EXPECT_TRUE(journal || journal.status().code == Code::invalid) << k;
  }
}

TEST_F(ForeignRows, OfAFileWithOtherTablesOrCellsAreRefused) {
  const auto refused = [&](const char* sql, const char* why) {
    const std::string before = bytes();
    execute(sql);
    const Result<std::string> rows = foreign_rows(bytes());
    EXPECT_TRUE(!rows && rows.status().message.find(why) != std::string::npos) << sql;
    std::ofstream(path("file"), std::ios::binary) << before;
  };
  refused("CREATE TABLE more(number INTEGER)", "tables");
  refused("ALTER TABLE pictures ADD COLUMN more BLOB AS (zeroblob(1000000))", "tables");
  refused("DROP TABLE picture_uses", "tables");
  refused("UPDATE entries SET kind = 'comb'", "another kind");
  refused("UPDATE scenes SET raw = 'text'", "another kind");
  refused("PRAGMA user_version = 1000", "newer version");
  refused("PRAGMA user_version = 5", "no version");
  EXPECT_FALSE(foreign_rows("no database").ok());
  EXPECT_FALSE(foreign_rows("").ok());
}

TEST_F(ForeignRows, OfADamagedFileAreRefusedOrWhole) {
  const std::string good = bytes();
  std::mt19937 random(5);
  for (int k = 0; k < 300; ++k) {
    std::string bad = good;
    for (int flips = 0; flips <= k % 3; ++flips) bad[random() % bad.size()] ^= static_cast<char>(1u << random() % 8);
    const Result<std::string> rows = foreign_rows(bad);
    EXPECT_TRUE(rows || !rows.status().message.empty()) << k;
  }
}

}  // namespace
}  // namespace pelage::foreign_rows_test
