#include "server/history/journal.h"

#include <fstream>

#include "protocol/json/encode.h"
#include "server/history/codec.h"
#include "tests/unit/history/journal_fixture.h"

namespace pelage::testing {
namespace {

TEST_F(JournalTest, KeepsScenesAndEntriesOverARestart) {
  SceneSettings settings;
  settings.coats[0].coat.ramp[1].colour = {0.123456f, 1e-3f, 0.7f};
  settings.lights.resize(1);
  {
    const auto journal = open();
    ASSERT_TRUE(journal->add_scene(scene("a")).ok());
    ASSERT_TRUE(journal->add_scene(scene("b")).ok());
    Entry with_settings = entry(4);
    with_settings.settings = std::make_shared<const SceneSettings>(settings);
    with_settings.author = "Zoë \"Z\"";
    ASSERT_TRUE(journal->append("a", with_settings).ok());
    ASSERT_TRUE(journal->append("a", {5, EntryKind::undo, 1, "", {}, {1, 2}, nullptr}).ok());
  }
  const auto journal = open();
  EXPECT_EQ(*journal->scene_ids(), (std::vector<std::string>{"a", "b"}));
  const auto found = journal->scene("a");
  ASSERT_TRUE(found.ok());
  EXPECT_EQ(found->name, "fox \"1\"");
  EXPECT_EQ(found->model.name, "obj");
  EXPECT_EQ(found->model.prepare.up, Axis::plus_z);
  EXPECT_EQ(found->model.prepare.front, Axis::minus_x);
  EXPECT_TRUE(found->model.prepare.source_is_32_bit);
  EXPECT_EQ(found->model.prepare.crease_degrees, 30);
  EXPECT_EQ(found->model.prepare.flipped_parts, (std::vector<std::uint32_t>{2, 7}));
  EXPECT_EQ(found->model.raw, std::string("a\0b", 3));
  EXPECT_EQ(found->model.fur_patches, FurPatches::hard);
  EXPECT_EQ(found->first_revision, 3u);
  EXPECT_EQ(found->first_groom, scene("a").first_groom);
  const auto entries = journal->entries("a", 0);
  ASSERT_TRUE(entries.ok());
  ASSERT_EQ(entries->size(), 2u);
  EXPECT_EQ((*entries)[0].commands, "{}");
  EXPECT_EQ((*entries)[0].delta, entry(4).delta);
  EXPECT_EQ((*entries)[0].author, "Zoë \"Z\"");
  EXPECT_EQ((*entries)[1].author, "");
  EXPECT_EQ((*entries)[0].fields_hash, entry(4).fields_hash);
  ASSERT_TRUE((*entries)[0].settings);
  EXPECT_EQ((*entries)[0].settings->coats[0].coat.ramp[1].colour, settings.coats[0].coat.ramp[1].colour);
  EXPECT_EQ((*entries)[0].settings->lights.size(), 1u);
  EXPECT_EQ((*entries)[1].kind, EntryKind::undo);
  EXPECT_EQ((*entries)[1].argument, 1u);
  EXPECT_FALSE((*entries)[1].settings);
  EXPECT_EQ(journal->entries("a", 4)->size(), 1u);
}

TEST_F(JournalTest, GivesWhatLeadsFromOneRevisionToAnother) {
  const auto journal = open();
  ASSERT_TRUE(journal->add_scene(scene("a")).ok());
  FieldDelta expected;
  for (Revision r = 4; r <= 7; ++r) {
    Entry one = entry(r);
    one.delta = {{{Field::length, {static_cast<std::uint32_t>(r)}, {7}}, {Field::stretch, {1}, {5}}}};
    ASSERT_TRUE(journal->append("a", one).ok());
    if (r == 5 || r == 6) expected = compose(expected, one.delta);
  }
  EXPECT_EQ(*journal->change("a", 4, 6), expected);
  EXPECT_EQ(expected.vertices(), (std::vector<std::uint32_t>{5, 6})) << "what turned over twice is gone";
  EXPECT_TRUE(journal->change("a", 5, 5)->empty());
  EXPECT_EQ(journal->change("a", 4, 8).status().code, Code::internal) << "there is no entry 8";
  EXPECT_EQ(journal->change("b", 4, 6).status().code, Code::internal);
}

TEST_F(JournalTest, ANewModelEmptiesTheLogAndKeepsThePositionInTheList) {
  const auto journal = open();
  ASSERT_TRUE(journal->add_scene(scene("a")).ok());
  ASSERT_TRUE(journal->add_scene(scene("b")).ok());
  ASSERT_TRUE(journal->append("a", entry(4)).ok());
  StoredScene other = scene("a");
  other.model.name = "stl";
  other.first_revision = 5;
  ASSERT_TRUE(journal->replace_model(other).ok());
  EXPECT_TRUE(journal->entries("a", 0)->empty());
  EXPECT_EQ(journal->scene("a")->model.name, "stl");
  EXPECT_EQ(journal->scene("a")->first_revision, 5u);
  EXPECT_EQ(*journal->scene_ids(), (std::vector<std::string>{"a", "b"}));
}

TEST_F(JournalTest, RemovedScenesAreGoneWithTheirEntries) {
  const auto journal = open();
  ASSERT_TRUE(journal->add_scene(scene("a")).ok());
  ASSERT_TRUE(journal->append("a", entry(4)).ok());
  ASSERT_TRUE(journal->remove_scene("a").ok());
  EXPECT_TRUE(journal->scene_ids()->empty());
  EXPECT_TRUE(journal->entries("a", 0)->empty());
  EXPECT_FALSE(journal->append("a", entry(5)).ok());
}

TEST_F(JournalTest, NoRevisionIsWrittenTwice) {
  const auto journal = open();
  ASSERT_TRUE(journal->add_scene(scene("a")).ok());
  ASSERT_TRUE(journal->append("a", entry(4)).ok());
  EXPECT_FALSE(journal->append("a", entry(4)).ok());
}

TEST_F(JournalTest, SeveralEntriesAreWrittenAllOrNone) {
  const auto journal = open();
  ASSERT_TRUE(journal->add_scene(scene("a")).ok());
  EXPECT_TRUE(journal->append("a", std::vector{entry(4), entry(5)}).ok());
  EXPECT_FALSE(journal->append("a", std::vector{entry(6), entry(7), entry(5)}).ok());
  EXPECT_EQ(journal->entries("a", 0)->size(), 2u);
  EXPECT_TRUE(journal->append("a", std::vector{entry(6)}).ok());
}

TEST_F(JournalTest, ABranchHasTheEntriesUpToARevisionAndTheModel) {
  {
    const auto journal = open();
    ASSERT_TRUE(journal->add_scene(scene("a")).ok());
    Entry last = entry(6);
    last.kind = EntryKind::replay, last.author = "Ann";
    ASSERT_TRUE(journal->append("a", std::vector{entry(4), entry(5), last}).ok());
    ASSERT_TRUE(journal->branch("a", "b", "other \"name\"", 5).ok());
    ASSERT_TRUE(journal->branch("a", "c", "whole", 6).ok());
    EXPECT_FALSE(journal->branch("a", "b", "again", 5).ok()) << "the id is taken";
    ASSERT_TRUE(journal->remove_scene("a").ok());
  }
  const auto journal = open();
  EXPECT_EQ(*journal->scene_ids(), (std::vector<std::string>{"b", "c"}));
  const auto found = journal->scene("b");
  ASSERT_TRUE(found.ok());
  EXPECT_EQ(found->name, "other \"name\"");
  EXPECT_EQ(found->model.raw, scene("a").model.raw);
  EXPECT_EQ(found->model.prepare.up, Axis::plus_z);
  EXPECT_EQ(found->model.fur_patches, FurPatches::hard);
  EXPECT_EQ(found->first_revision, 3u);
  EXPECT_EQ(found->first_groom, scene("a").first_groom);
  EXPECT_EQ(journal->entries("b", 0)->size(), 2u);
  EXPECT_EQ(journal->entries("b", 0)->front().delta, entry(4).delta);
  ASSERT_EQ(journal->entries("c", 0)->size(), 3u);
  EXPECT_EQ(journal->entries("c", 0)->back().kind, EntryKind::replay);
  EXPECT_EQ(journal->entries("c", 0)->back().author, "Ann");
}

TEST_F(JournalTest, RefusesWhatItCannotRead) {
  open().reset();
  execute("PRAGMA user_version = 99");
  EXPECT_NE(refusal().message.find("newer"), std::string::npos);
  std::filesystem::remove(path_);
  execute("CREATE TABLE shopping(item TEXT)");
  EXPECT_NE(refusal().message.find("another database"), std::string::npos);
  std::filesystem::remove(path_);
  std::ofstream(path_) << std::string(5000, 'x');
  EXPECT_EQ(refusal().code, Code::internal);
  path_ = (folder_ / "missing" / "pelage.sqlite").string();
  EXPECT_EQ(refusal().code, Code::internal);
}

TEST_F(JournalTest, IsHeldByOneServerAtATime) {
  auto journal = Journal::open_guarded(path_);
  ASSERT_TRUE(journal.ok()) << journal.status().message;
  EXPECT_EQ(Journal::open_guarded(path_).status().code, Code::unavailable);
  journal = failure(Code::internal, "closed");
  EXPECT_TRUE(Journal::open_guarded(path_).ok());
}

TEST_F(JournalTest, DamagedEntriesAreReported) {
  {
    const auto journal = open();
    ASSERT_TRUE(journal->add_scene(scene("a")).ok());
    ASSERT_TRUE(journal->append("a", entry(4)).ok());
  }
  execute("UPDATE entries SET delta = x'05'");
  EXPECT_EQ(open()->entries("a", 0).status().code, Code::internal);
}

TEST_F(JournalTest, ChangesAreFoundByTheirRequestAfterARestart) {
  {
    const auto journal = open();
    ASSERT_TRUE(journal->add_scene(scene("a")).ok());
    std::vector<Entry> amended{entry(4), entry(5), entry(6)};
    amended[1].request = amended[2].request = KeyedRequest{"/a/amend", "k", "print"};
    ASSERT_TRUE(journal->append("a", amended).ok());
    ASSERT_TRUE(journal->branch("a", "b", "b", 6).ok());
  }
  const auto journal = open();
  const auto found = journal->change_of_request("/a/amend", "k");
  ASSERT_TRUE(found.ok() && *found);
  EXPECT_EQ((*found)->revision, 6u) << "the last of them";
  EXPECT_EQ((*found)->fields_hash, entry(6).fields_hash);
  EXPECT_EQ((*found)->fingerprint, "print");
  EXPECT_EQ((*found)->scene, "a");
  for (const char* other : {"", "K", "other"}) EXPECT_FALSE(*journal->change_of_request("/a/amend", other)) << other;
  EXPECT_FALSE(*journal->change_of_request("/a/undo", "k"));
  ASSERT_TRUE(journal->remove_scene("a").ok());
  EXPECT_FALSE(*journal->change_of_request("/a/amend", "k")) << "nothing that can be answered is left";
}

TEST_F(JournalTest, AFlippedBitOrAMissingRowIsFoundWhereItIs) {
  {
    const auto journal = open();
    for (const char* id : {"a", "b"}) {
      ASSERT_TRUE(journal->add_scene(scene(id)).ok());
      ASSERT_TRUE(journal->append(id, std::vector{entry(4), entry(5), entry(6), entry(7)}).ok());
    }
    ASSERT_TRUE(journal->branch("a", "c", "c", 6).ok());
    ASSERT_TRUE(journal->append("c", entry(7)).ok());
  }
  const std::string whole = path_ + ".whole";
  std::filesystem::copy_file(path_, whole);
  for (const char* damage : {"UPDATE entries SET argument = 1 WHERE scene = 'a' AND revision = 6",
                             "UPDATE entries SET commands = commands || ' ' WHERE scene = 'a' AND revision = 6",
                             "UPDATE entries SET author = 'Eve' WHERE scene = 'a' AND revision = 6",
                             "UPDATE entries SET delta = CAST(delta AS TEXT) WHERE scene = 'a' AND revision = 6",
                             "UPDATE entries SET hash_low = 8 WHERE scene = 'a' AND revision = 6",
                             "UPDATE entries SET chain = chain + 1 WHERE scene = 'a' AND revision = 6",
                             "DELETE FROM entries WHERE scene = 'a' AND revision = 6"}) {
    std::filesystem::copy_file(whole, path_, std::filesystem::copy_options::overwrite_existing);
    execute(damage);
    const auto journal = open();
    std::vector<Revision> read;
    Status status =
        journal->for_each_entry("a", 3, [&](const Entry& one) { return read.push_back(one.revision), Status{}; });
    EXPECT_EQ(status.code, Code::internal) << damage;
    EXPECT_EQ(read, (std::vector<Revision>{4, 5})) << damage;
    EXPECT_TRUE(journal->scene("a").ok()) << damage;
    for (const char* other : {"b", "c"}) EXPECT_EQ(journal->entries(other, 0)->size(), 4u) << damage;
  }
  for (const char* damage :
       {"UPDATE scenes SET raw = x'616263' WHERE id = 'a'", "UPDATE scenes SET name = '' WHERE id = 'a'",
        "UPDATE scenes SET first_revision = 2 WHERE id = 'a'"}) {
    std::filesystem::copy_file(whole, path_, std::filesystem::copy_options::overwrite_existing);
    execute(damage);
    EXPECT_EQ(open()->scene("a").status().code, Code::internal) << damage;
    EXPECT_TRUE(open()->scene("c").ok()) << damage;
  }
}

TEST_F(JournalTest, SubdivisionsAndFirstSettingsStayOverARestart) {
  StoredScene finer;
  finer.id = "a", finer.first_revision = 5, finer.first_groom = {{{Field::length, {9}, {1}}}};
  finer.model.subdivisions = {{{0, 4}, {6, 7}}, {}, {{2, 3}}};
  SceneSettings settings;
  settings.coats[0].coat.count = 77;
  finer.first_settings = std::make_shared<const SceneSettings>(settings);
  {
    const auto journal = open();
    ASSERT_TRUE(journal->add_scene(scene("a")).ok());
    ASSERT_TRUE(journal->append("a", entry(4)).ok());
    ASSERT_TRUE(journal->reshape_model(finer).ok());
  }
  {
    const auto journal = open();
    const auto found = journal->scene("a");
    ASSERT_TRUE(found.ok()) << found.status().message;
    EXPECT_EQ(found->model.subdivisions, finer.model.subdivisions);
    EXPECT_EQ(found->model.raw, scene("a").model.raw);
    EXPECT_EQ(found->first_groom, finer.first_groom);
    EXPECT_EQ(found->first_revision, 5u);
    ASSERT_TRUE(found->first_settings);
    EXPECT_EQ(found->first_settings->coats[0].coat.count, 77);
    EXPECT_TRUE(journal->entries("a", 0)->empty());
    ASSERT_TRUE(journal->replace_model(scene("a")).ok());
    EXPECT_TRUE(journal->scene("a")->model.subdivisions.empty()) << "a new model is not subdivided";
    EXPECT_FALSE(journal->scene("a")->first_settings);
    ASSERT_TRUE(journal->reshape_model(finer).ok());
  }
  for (const char* damage :
       {"x'010000'", "x'01000000'", "x'010000000500000005000000'", "x'0200000000000000020000000200000003000000'"}) {
    execute((std::string("UPDATE scenes SET subdivisions = ") + damage).c_str());
    EXPECT_EQ(open()->scene("a").status().code, Code::internal) << damage;
  }
}

Entry with_picture(Revision revision, const std::string& name) {
  SceneSettings settings;
  settings.skin_texture = name;
  Entry entry;
  entry.revision = revision, entry.commands = "{}";
  entry.settings = std::make_shared<const SceneSettings>(settings);
  return entry;
}

TEST_F(JournalTest, PicturesStayWhileALogNamesThem) {
  const std::string used(32, 'a'), unused(32, 'b');
  {
    const auto journal = open();
    ASSERT_TRUE(journal->add_scene(scene("a")).ok());
    ASSERT_TRUE(journal->add_scene(scene("b")).ok());
    ASSERT_TRUE(journal->add_picture(used, std::string("x\0y", 3)).ok());
    ASSERT_TRUE(journal->add_picture(used, "another").ok());
    ASSERT_TRUE(journal->add_picture(unused, "z").ok());
    ASSERT_TRUE(journal->append("a", with_picture(4, used)).ok());
    ASSERT_TRUE(journal->append("b", with_picture(4, used)).ok());
    EXPECT_TRUE(journal->has_picture(unused));
  }
  const auto journal = open();
  EXPECT_FALSE(journal->has_picture(unused)) << "it was never used, and a start drops it";
  EXPECT_EQ(*journal->picture(used), std::string("x\0y", 3));
  EXPECT_EQ((*journal->entries("a", 0))[0].settings->skin_texture, used);
  ASSERT_TRUE(journal->remove_scene("a").ok());
  EXPECT_TRUE(journal->has_picture(used));
  ASSERT_TRUE(journal->replace_model(scene("b")).ok());
  EXPECT_FALSE(journal->has_picture(used));
  EXPECT_EQ(journal->picture(used).status().code, Code::internal);
}

TEST_F(JournalTest, ABranchKeepsThePicturesOfItsLog) {
  const std::string used(32, 'a');
  const auto journal = open();
  ASSERT_TRUE(journal->add_scene(scene("a")).ok());
  ASSERT_TRUE(journal->add_picture(used, "x").ok());
  ASSERT_TRUE(journal->append("a", with_picture(4, used)).ok());
  ASSERT_TRUE(journal->branch("a", "b", "b", 4).ok());
  ASSERT_TRUE(journal->remove_scene("a").ok());
  EXPECT_TRUE(journal->has_picture(used));
  ASSERT_TRUE(journal->remove_scene("b").ok());
  EXPECT_FALSE(journal->has_picture(used));
}

TEST_F(JournalTest, AnEntryWithAPictureThatIsNotThereIsNotWritten) {
  const auto journal = open();
  ASSERT_TRUE(journal->add_scene(scene("a")).ok());
  EXPECT_FALSE(journal->append("a", with_picture(4, std::string(32, 'a'))).ok());
  EXPECT_TRUE(journal->entries("a", 0)->empty());
}

}  // namespace
}  // namespace pelage::testing
