// Journals of earlier versions of the program, which it upgrades.
#include "server/history/schema.h"
#include "tests/unit/history/journal_fixture.h"

namespace pelage::testing {
namespace {

class JournalUpgrade : public JournalTest {
 protected:
  /// Replaces the tables by those of version 9.
  void make_it_version_9() const {
    execute(R"(
      ALTER TABLE picture_uses RENAME TO new_picture_uses; ALTER TABLE pictures RENAME TO new_pictures;
      ALTER TABLE entries RENAME TO new_entries; ALTER TABLE scenes RENAME TO new_scenes; DROP TABLE requests;
      CREATE TABLE scenes(
        number INTEGER PRIMARY KEY, id TEXT NOT NULL UNIQUE, name TEXT NOT NULL,
        model TEXT NOT NULL, up INTEGER NOT NULL, front INTEGER NOT NULL, source_is_32_bit INTEGER NOT NULL,
        first_revision INTEGER NOT NULL, first_groom BLOB NOT NULL, raw BLOB NOT NULL, fur_patches INTEGER NOT NULL,
        subdivisions BLOB NOT NULL, settings TEXT, creases_and_flips TEXT NOT NULL DEFAULT '');
      CREATE TABLE entries(
        scene TEXT NOT NULL REFERENCES scenes(id) ON DELETE CASCADE, revision INTEGER NOT NULL,
        kind INTEGER NOT NULL, argument INTEGER NOT NULL, commands TEXT NOT NULL, settings TEXT,
        hash_low INTEGER NOT NULL, hash_high INTEGER NOT NULL, delta BLOB NOT NULL, author TEXT NOT NULL DEFAULT '',
        request_key TEXT NOT NULL DEFAULT '', PRIMARY KEY(scene, revision));
      CREATE INDEX entries_by_request ON entries(scene, request_key) WHERE request_key <> '';
      CREATE TABLE pictures(name TEXT PRIMARY KEY, bytes BLOB NOT NULL);
      CREATE TABLE picture_uses(
        scene TEXT NOT NULL REFERENCES scenes(id) ON DELETE CASCADE, picture TEXT NOT NULL REFERENCES pictures(name),
        PRIMARY KEY(scene, picture));
      INSERT INTO scenes SELECT number, id, name, model, up, front, source_is_32_bit, first_revision, first_groom, raw,
        fur_patches, subdivisions, settings, creases_and_flips FROM new_scenes;
      INSERT INTO entries SELECT scene, revision, kind, argument, commands, settings, hash_low, hash_high, delta,
        author, 'key' FROM new_entries;
      INSERT INTO pictures SELECT name, 'picture as it is' FROM new_pictures;
      INSERT INTO picture_uses SELECT * FROM new_picture_uses;
      DROP TABLE new_picture_uses; DROP TABLE new_pictures; DROP TABLE new_entries; DROP TABLE new_scenes;
      PRAGMA user_version = 9)");
  }
};

TEST_F(JournalUpgrade, AnOlderJournalIsRefusedAndLeftAsItIs) {
  open().reset();
  execute("PRAGMA user_version = 2");
  EXPECT_EQ(refusal().code, Code::internal);
  EXPECT_NE(refusal().message.find("older version"), std::string::npos);
}

TEST_F(JournalUpgrade, LoggedNamesOfVersionFiveAreTakenOver) {
  {
    const auto journal = open();
    ASSERT_TRUE(journal->add_scene(scene("a")).ok());
    Entry logged = entry(4);
    logged.commands = R"([{"op":"length","layer":"a \"layer\": b","mode":"least"},{"op":"layer","name":"layer"}])";
    ASSERT_TRUE(journal->append("a", logged).ok());
  }
  make_it_version_9();
  execute(
      "DROP INDEX entries_by_request; ALTER TABLE entries DROP COLUMN author; ALTER TABLE entries DROP COLUMN "
      "request_key; ALTER TABLE scenes DROP COLUMN creases_and_flips; PRAGMA user_version = 5");
  const auto entries = open()->entries("a", 0);
  ASSERT_TRUE(entries.ok()) << entries.status().message;
  EXPECT_EQ(entries->at(0).commands,
            R"([{"op":"length","edit_layer":"a \"layer\": b","mode":"min"},{"op":"edit_layer","name":"layer"}])");
}

TEST_F(JournalUpgrade, ChangesOfVersionSixHaveNoAuthor) {
  {
    const auto journal = open();
    ASSERT_TRUE(journal->add_scene(scene("a")).ok());
    Entry named = entry(4);
    named.author = "Ann";
    ASSERT_TRUE(journal->append("a", named).ok());
  }
  make_it_version_9();
  execute(
      "DROP INDEX entries_by_request; ALTER TABLE entries DROP COLUMN author; ALTER TABLE entries DROP COLUMN "
      "request_key; ALTER TABLE scenes DROP COLUMN creases_and_flips; PRAGMA user_version = 6");
  {
    const auto journal = open();
    ASSERT_EQ(journal->entries("a", 0)->size(), 1u);
    EXPECT_EQ(journal->entries("a", 0)->front().author, "");
    EXPECT_EQ(journal->entries("a", 0)->front().delta, entry(4).delta);
    Entry next = entry(5);
    next.author = "Ben";
    ASSERT_TRUE(journal->append("a", next).ok());
    ASSERT_TRUE(journal->branch("a", "b", "b", 5).ok());
  }
  EXPECT_EQ(open()->entries("a", 0)->back().author, "Ben");
  EXPECT_EQ(open()->entries("b", 0)->back().author, "Ben");
}

TEST_F(JournalUpgrade, ScenesOfVersionEightAreCalmAndKeepTheirColours) {
  StoredScene old = scene("a");
  old.first_groom = {{{Field::root_colour, {2}, {1, 2, 3, 4}}, {Field::tip_colour, {5}, {4, 3, 2, 1}}}};
  {
    const auto journal = open();
    ASSERT_TRUE(journal->add_scene(old).ok());
    SceneSettings settings;
    settings.coats[0].coat.count = 77;
    Entry logged = entry(4);
    logged.settings = std::make_shared<const SceneSettings>(settings);
    ASSERT_TRUE(journal->append("a", logged).ok());
  }
  make_it_version_9();
  execute(
      "UPDATE entries SET settings = json_remove(settings, (SELECT fullkey FROM json_each(settings, '$.commands') "
      "WHERE "
      "json_extract(value, '$.op') = 'set_wind')); PRAGMA user_version = 8");
  const auto journal = open();
  const auto entries = journal->entries("a", 0);
  ASSERT_TRUE(entries.ok()) << entries.status().message;
  EXPECT_EQ(entries->at(0).settings->coats[0].coat.count, 77);
  EXPECT_EQ(entries->at(0).settings->wind, Wind{});
  EXPECT_EQ(journal->scene("a")->first_groom, old.first_groom);
}

TEST_F(JournalUpgrade, ANewJournalSaysTheVersionThatTheProgramWrites) {
  open().reset();
  EXPECT_EQ(answer("PRAGMA user_version"), std::to_string(schema_version));
}

TEST_F(JournalUpgrade, AnUpgradedJournalIsAsANewOne) {
  const char* text = "SELECT group_concat(sql, '\n') FROM (SELECT sql FROM sqlite_master ORDER BY name)";
  const std::string used(32, 'a');
  {
    const auto journal = open();
    ASSERT_TRUE(journal->add_scene(scene("a")).ok());
    ASSERT_TRUE(journal->add_scene(scene("b")).ok());
    ASSERT_TRUE(journal->add_picture(used, "x").ok());
    Entry with_picture = entry(4);
    with_picture.pictures = {used};
    ASSERT_TRUE(journal->append("a", std::vector{with_picture, entry(5), entry(6)}).ok());
    ASSERT_TRUE(journal->append("b", entry(4)).ok());
  }
  const std::string fresh = answer(text);
  const char* chains = "SELECT group_concat(scene || revision || chain) FROM entries";
  const std::string fresh_chains = answer(chains);
  make_it_version_9();
  {
    const auto journal = open();
    EXPECT_EQ(journal->entries("a", 0)->size(), 3u);
    EXPECT_EQ(journal->scene("a")->model.raw, scene("a").model.raw);
    EXPECT_EQ(*journal->picture(used), "picture as it is");
    EXPECT_FALSE(journal->append("a", entry(6)).ok());
    EXPECT_TRUE(journal->append("a", entry(7)).ok());
    ASSERT_TRUE(journal->remove_scene("b").ok());
    EXPECT_TRUE(journal->entries("b", 0)->empty());
  }
  EXPECT_EQ(answer(text), fresh);
  EXPECT_EQ(answer("PRAGMA user_version"), std::to_string(schema_version));
  EXPECT_EQ(answer(chains).substr(0, fresh_chains.find(",b4")), fresh_chains.substr(0, fresh_chains.find(",b4")));
  EXPECT_EQ(open()->entries("a", 0)->size(), 4u);
}

}  // namespace
}  // namespace pelage::testing
