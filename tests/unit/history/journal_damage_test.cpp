// What happens to a journal when its disk or its files fail.
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>

#include "server/history/journal.h"
#include "server/history/sqlite.h"
#include "tests/support/failing_disk.h"

namespace pelage::journal_damage_test {
namespace {

namespace fs = std::filesystem;

class JournalDamageTest : public ::testing::Test {
 protected:
  void SetUp() override {
    const auto* test = ::testing::UnitTest::GetInstance()->current_test_info();
    folder_ = fs::path(::testing::TempDir()) / (std::string("pelage_damage_") + test->name());
    fs::remove_all(folder_);
    fs::create_directories(data());
  }
  void TearDown() override { fs::remove_all(folder_); }

  fs::path data() const { return folder_ / "data"; }
  std::string file() const { return (data() / "pelage.sqlite").string(); }

  static std::unique_ptr<Journal> open(const std::string& path) {
    auto journal = Journal::open_guarded(path);
    EXPECT_TRUE(journal.ok()) << journal.status().message;
    return journal.ok() ? std::move(*journal) : nullptr;
  }
  /// Copies the files as a kill at this moment would leave them to the next start.
  std::string killed(const char* name) const {
    const fs::path copy = folder_ / name;
    fs::remove_all(copy);
    fs::copy(data(), copy);
    return (copy / "pelage.sqlite").string();
  }

  static StoredScene scene(const std::string& id) {
    return {id, id, {"obj", {}, "raw"}, 3, {{{Field::length, {2}, {7}}}}};
  }
  static Entry entry(Revision revision) {
    return {revision, EntryKind::command, 0, "{}", {{{Field::mask, {7}, {9}}}}, {1, 5}, nullptr};
  }
  static std::vector<Revision> revisions(const Journal& journal, const std::string& scene = "a") {
    std::vector<Revision> revisions;
    const auto entries = journal.entries(scene, 0);
    for (const Entry& one : *entries) revisions.push_back(one.revision);
    return revisions;
  }

  fs::path folder_;
};

using Revisions = std::vector<Revision>;

TEST_F(JournalDamageTest, WhatFailedAtItsSyncNeverComesBack) {
  FailingDisk disk;
  for (const int failures : {1, 1000}) {
    fs::remove_all(data()), fs::create_directories(data());
    const auto journal = open(file());
    ASSERT_TRUE(journal->add_scene(scene("a")).ok());
    ASSERT_TRUE(journal->append("a", entry(4)).ok());
    FailingDisk::syncs_to_fail = failures;
    EXPECT_FALSE(journal->append("a", entry(5)).ok());
    EXPECT_FALSE(journal->append("a", std::vector{entry(5), entry(6)}).ok() && failures > 1);
    EXPECT_EQ(journal->health().ok(), failures == 1);
    FailingDisk::syncs_to_fail = 0;
    const Revisions now = revisions(*journal);
    EXPECT_EQ(revisions(*open(killed("then"))), now) << failures;
    EXPECT_EQ(now, failures == 1 ? (Revisions{4, 5, 6}) : Revisions{4});
    EXPECT_TRUE(journal->health().ok());
    EXPECT_TRUE(journal->append("a", entry(now.back() + 1)).ok());
    EXPECT_EQ(revisions(*open(killed("later"))).size(), now.size() + 1);
  }
}

TEST_F(JournalDamageTest, ReportsALogThatIsShorterThanClientsWereTold) {
  { ASSERT_TRUE(open(file())->add_scene(scene("a")).ok()); }
  const auto journal = open(file());
  ASSERT_TRUE(journal->append("a", std::vector{entry(4), entry(5)}).ok());
  ASSERT_TRUE(journal->add_scene(scene("b")).ok());
  const std::string whole = killed("whole"), gone = killed("gone"), cut = killed("cut"), flipped = killed("flipped");
  EXPECT_TRUE(open(whole)->lost().empty());

  fs::remove(gone + "-wal");
  fs::resize_file(cut + "-wal", fs::file_size(cut + "-wal") - 1);
  std::fstream wal(flipped + "-wal", std::ios::in | std::ios::out | std::ios::binary);
  wal.seekp(100).put('\x55');
  wal.close();

  for (const std::string& path : {gone, flipped}) {
    const auto shorter = open(path);
    ASSERT_EQ(shorter->lost().size(), 2u) << path;
    EXPECT_EQ(shorter->lost()[0].scene, "a");
    EXPECT_EQ(shorter->lost()[0].acknowledged, 5u);
    EXPECT_EQ(shorter->lost()[0].present, 3u);
    EXPECT_EQ(shorter->lost()[1].scene, "b");
    EXPECT_FALSE(shorter->lost()[1].present);
  }
  EXPECT_TRUE(open(gone)->lost().empty()) << "it was said";
  const auto without_last = open(cut);
  ASSERT_EQ(without_last->lost().size(), 1u);
  EXPECT_EQ(without_last->lost()[0].scene, "b");
}

TEST_F(JournalDamageTest, WhatWasRemovedIsNotLost) {
  const auto journal = open(file());
  for (const char* id : {"a", "b"}) ASSERT_TRUE(journal->add_scene(scene(id)).ok());
  ASSERT_TRUE(journal->append("a", entry(4)).ok());
  ASSERT_TRUE(journal->replace_model(scene("b")).ok());
  ASSERT_TRUE(journal->remove_scene("a").ok());
  EXPECT_TRUE(open(killed("then"))->lost().empty());
}

TEST_F(JournalDamageTest, IgnoresABrokenNoteOfRevisions) {
  { ASSERT_TRUE(open(file())->add_scene(scene("a")).ok()); }
  for (const char* text : {"", "a 9 ff\nend 12\n", "a", "end"}) {
    std::ofstream(file() + "-acknowledged") << text;
    EXPECT_TRUE(open(file())->lost().empty()) << text;
  }
}

TEST_F(JournalDamageTest, NothingIsWrittenToFilesThatAreGone) {
  const auto journal = open(file());
  ASSERT_TRUE(journal->add_scene(scene("a")).ok());
  EXPECT_TRUE(journal->health().ok());
  for (const std::string& path : {file(), file() + "-wal", data().string()}) {
    const fs::path aside = folder_ / "aside";
    fs::rename(path, aside);
    EXPECT_EQ(journal->append("a", entry(4)).code, Code::unavailable) << path;
    EXPECT_EQ(journal->health().code, Code::unavailable) << path;
    EXPECT_NE(journal->health().message.find("removed or replaced"), std::string::npos);
    fs::rename(aside, path);
    EXPECT_TRUE(journal->health().ok()) << path;
  }
  fs::copy_file(file(), folder_ / "copy");
  fs::rename(folder_ / "copy", file());
  EXPECT_EQ(journal->health().code, Code::unavailable) << "another file in its place";
  EXPECT_TRUE(revisions(*journal).empty());
}

TEST_F(JournalDamageTest, AFullDiskRefusesChangesAndNothingElse) {
  FailingDisk disk;
  const auto journal = open(file());
  ASSERT_TRUE(journal->add_scene(scene("a")).ok());
  EXPECT_EQ(fs::file_size(file() + "-reserve"), min_free_bytes);
  FailingDisk::is_full = true;
  EXPECT_EQ(journal->append("a", entry(4)).code, Code::unavailable);
  EXPECT_EQ(journal->add_scene(scene("b")).code, Code::unavailable);
  EXPECT_TRUE(revisions(*journal).empty());
  EXPECT_FALSE(journal->remove_scene("a").ok()) << "this disk stays full without the reserve too";
  FailingDisk::is_full = false;
  EXPECT_TRUE(journal->append("a", entry(4)).ok());
  EXPECT_TRUE(journal->remove_scene("a").ok());
  EXPECT_EQ(fs::file_size(file() + "-reserve"), min_free_bytes) << "taken again";
}

TEST_F(JournalDamageTest, ASecondServerLeavesTheReserveOfTheFirst) {
  const auto journal = open(file());
  EXPECT_FALSE(Journal::open_guarded(file()).ok());
  EXPECT_EQ(fs::file_size(file() + "-reserve"), min_free_bytes);
}

TEST_F(JournalDamageTest, ARemovedSceneGivesItsRoomBack) {
  const auto journal = open(file());
  StoredScene large = scene("a");
  large.model.raw = std::string(30'000'000, 'x');
  ASSERT_TRUE(journal->add_scene(large).ok());
  ASSERT_TRUE(journal->add_scene(scene("b")).ok());
  ASSERT_TRUE(journal->append("b", entry(4)).ok());
  ASSERT_TRUE(journal->remove_scene("a").ok());
  EXPECT_LT(fs::file_size(file()) + fs::file_size(file() + "-wal"), 1'000'000u);
  EXPECT_EQ(revisions(*journal, "b"), Revisions{4});
}

TEST_F(JournalDamageTest, OfPicturesThatNoLogNamesTheNewestStay) {
  const auto journal = open(file());
  ASSERT_TRUE(journal->add_scene(scene("a")).ok());
  ASSERT_TRUE(journal->add_picture("used", "x").ok());
  Entry naming = entry(4);
  naming.pictures = {"used"};
  ASSERT_TRUE(journal->append("a", naming).ok());
  for (int i = 0; i < 70; ++i) ASSERT_TRUE(journal->add_picture(std::to_string(i), "x").ok());
  EXPECT_TRUE(journal->has_picture("used"));
  for (int i = 0; i < 70; ++i) EXPECT_EQ(journal->has_picture(std::to_string(i)), i >= 6) << i;
}

TEST_F(JournalDamageTest, PicturesAreCompressedAndCheckedAsTheyAreRead) {
  const std::string name(32, 'a'), bytes(1'000'000, 'x');
  {
    const auto journal = open(file());
    ASSERT_TRUE(journal->add_scene(scene("a")).ok());
    ASSERT_TRUE(journal->add_picture(name, bytes).ok());
    Entry naming = entry(4);
    naming.pictures = {name};
    ASSERT_TRUE(journal->append("a", naming).ok());
    EXPECT_EQ(*journal->picture(name), bytes);
  }
  EXPECT_LT(fs::file_size(file()), 200'000u);
  for (const char* damaged : {"x'00'", "x''", "x'40420f0000000000789c00'", "x'ffffffffffffffff789c'",
                              "substr(bytes, 1, 100) || x'00' || substr(bytes, 102)"}) {
    {
      auto database = Database::open(file());
      ASSERT_TRUE(
          database->execute((std::string("UPDATE pictures SET bytes = CAST(") + damaged + " AS BLOB)").c_str()).ok());
    }
    EXPECT_EQ(open(file())->picture(name).status().code, Code::internal) << damaged;
  }
}

}  // namespace
}  // namespace pelage::journal_damage_test
