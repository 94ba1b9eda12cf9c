// Untrusted scenes that no command could have made are each refused with a reason; a genuine one is accepted.
#include "server/scene/foreign_scene.h"

#include <functional>

#include "protocol/json/encode.h"
#include "server/import/import.h"
#include "server/scene/map_pictures.h"
#include "tests/unit/scene/store_fixture.h"

namespace pelage::foreign_scene_test {
namespace {

const std::string nothing = encode(std::vector<Command>{SetSymmetry{}});  // the JSON of commands that change no field

class ForeignScene : public StoreTest {
 protected:
  void SetUp() override {
    StoreTest::SetUp();
    scene_ = make();
    execute(*scene_, {comb_at(*scene_, 5)});
    execute(*scene_, {SetCoat{}, comb_at(*scene_, 50)});
    Checkpoint checkpoint;
    checkpoint.name = "here";
    execute(*scene_, {checkpoint});
    move(*scene_, Undo{1});
    ASSERT_TRUE(store_->save(*scene_, (folder_ / "saved").string()).ok());
    const auto saved = Journal::open((folder_ / "saved").string());
    ASSERT_TRUE(saved.ok());
    stored_ = *(*saved)->scene(scene_->id());
    entries_ = *(*saved)->entries(scene_->id(), 0);
    fields_ = FieldSet(scene_->summary().report.vertices);
    fields_.apply(stored_.first_groom);
    for (const Entry& entry : entries_) fields_.apply(entry.delta);
  }

  /// Saves the scene as it is now to its own file. Returns why it is refused, or "".
  std::string refusal(const std::vector<std::string>& pictures = {}) {
    const std::string path = (folder_ / ("file" + std::to_string(++files_))).string();
    const auto file = Journal::open(path);
    EXPECT_TRUE(file.ok() && (*file)->add_scene(stored_).ok());
    for (const std::string& picture : pictures) EXPECT_TRUE((*file)->add_picture(picture, picture_).ok());
    EXPECT_TRUE((*file)->append(stored_.id, entries_).ok());
    return check_foreign(**file, stored_, *scene_->model()).message;
  }

  /// Appends an entry with these commands that sets a field at one vertex.
  Entry& add(EntryKind kind, std::string commands, Field field = Field::length, glm::vec4 value = {0.5f, 0, 0, 0}) {
    FieldDelta delta;
    FieldDelta::Part part{field, {}, {}};
    put_change(part, 3, fields_.value(field, 3), value);
    if (!part.vertices.empty()) delta.parts.push_back(part);
    fields_.apply(delta);
    entries_.push_back({entries_.back().revision + 1, kind, 0, std::move(commands), delta, fields_.hash(), nullptr});
    return entries_.back();
  }
  void add_settings(const std::function<void(SceneSettings&)>& change) {
    SceneSettings settings;
    change(settings);
    add(EntryKind::command, nothing).settings = std::make_shared<const SceneSettings>(settings);
  }

  std::shared_ptr<Scene> scene_;
  StoredScene stored_;
  std::vector<Entry> entries_;
  FieldSet fields_{0};
  std::string picture_ = encode_raw_image({1, 1, {1, 2, 3, 4}});
  int files_ = 0;
};

constexpr float nan = std::numeric_limits<float>::quiet_NaN();

TEST_F(ForeignScene, WhatCommandsMadeIsTaken) {
  EXPECT_EQ(refusal(), "");
  add(EntryKind::command, nothing);
  EXPECT_EQ(refusal(), "");
  const std::string name = name_of_picture(picture_);
  add_settings([&](SceneSettings& settings) { settings.skin_texture = name; });
  EXPECT_EQ(refusal({name}), "");
}

TEST_F(ForeignScene, ValuesOutOfTheirRangeAreRefused) {
  const std::vector<Entry> good = entries_;
  const std::vector<std::pair<Field, glm::vec4>> bad = {
      {Field::length, {nan, 0, 0, 0}},        {Field::length, {-1e-3f, 0, 0, 0}},
      {Field::length, {11, 0, 0, 0}},         {Field::density, {1.5f, 0, 0, 0}},
      {Field::direction, {0.9f, 0.9f, 0, 0}}, {Field::root_colour, {0, 0, 1e30f, 0}}};
  for (const auto& [field, value] : bad) {
    FieldSet before = fields_;
    add(EntryKind::command, nothing, field, value);
    EXPECT_NE(refusal().find("out of range"), std::string::npos) << shape_of(field).name << ' ' << value.x;
    entries_ = good, fields_ = std::move(before);
  }
}

TEST_F(ForeignScene, EntriesThatDoNotFollowAreRefused) {
  const std::vector<Entry> good = entries_;
  const FieldSet before = fields_;
  const auto refused = [&](const char* why) {
    EXPECT_NE(refusal().find(why), std::string::npos) << refusal();
    entries_ = good, fields_ = before;
  };
  add(EntryKind::command, nothing).fields_hash.low ^= 1, refused("lead to the fields");
  add(EntryKind::command, nothing).revision += 1, refused("follow those before it");
  add(EntryKind::undo, "").argument = 100, refused("follow those before it");
  add(EntryKind::revert, "").argument = 100, refused("follow those before it");
  add(EntryKind::command, nothing).author = "a\nb", refused("follow those before it");
  add(EntryKind::undo, nothing), refused("has commands");
  add(EntryKind::join, nothing), refused("did not begin");
  add(EntryKind::join, encode(std::vector<Command>{comb_at(*scene_, 5)})), refused("did not begin");
  add(EntryKind::command, nothing).delta.parts[0].vertices[0] = 1'000'000, refused("does not have");
}

TEST_F(ForeignScene, CommandsBeyondTheirLimitsAreRefused) {
  const std::vector<Entry> good = entries_;
  const FieldSet before = fields_;
  const auto refused = [&](const std::string& commands, const char* why) {
    add(EntryKind::command, commands);
    EXPECT_NE(refusal().find(why), std::string::npos) << refusal();
    entries_ = good, fields_ = before;
  };
  refused("none", "entry 5");
  refused(R"([{"op":"no_such_op"}])", "entry 5");
  Comb comb = comb_at(*scene_, 5);
  comb.stroke->samples[0].position = SurfaceSample{2'000'000, {1, 0, 0}};
  refused(encode(std::vector<Command>{comb}), "no such triangle");
  comb.stroke->samples[0].position = PositionSample{{1e12, 0, 0}};
  refused(encode(std::vector<Command>{comb}), "too far");
  ApplyMap map;
  map.picture = std::string(32, 'a');
  refused(encode(std::vector<Command>{map}), "picture that the file lacks");
}

TEST_F(ForeignScene, SettingsThatNameWhatIsNotThereAreRefused) {
  const std::vector<Entry> good = entries_;
  const FieldSet before = fields_;
  const auto refused = [&](const char* why, const std::function<void(SceneSettings&)>& change) {
    add_settings(change);
    EXPECT_NE(refusal().find(why), std::string::npos) << refusal();
    entries_ = good, fields_ = before;
  };
  refused("checkpoint", [](SceneSettings& settings) { settings.checkpoints = {{"later", 100}}; });
  refused("one name", [](SceneSettings& settings) { settings.layers = {{.name = "a"}, {.name = "a"}}; });
  refused("too far", [](SceneSettings& settings) { settings.eyes.resize(1), settings.eyes[0].position.x = 1e12; });
}

TEST_F(ForeignScene, PicturesAreWhatTheirNamesSay) {
  const std::string other(32, 'a');
  add_settings([&](SceneSettings& settings) { settings.skin_texture = other; });
  EXPECT_NE(refusal({other}).find("its name says"), std::string::npos) << refusal({other});
  entries_.pop_back();
  picture_ = "none";
  const std::string name = name_of_picture(picture_);
  add_settings([&](SceneSettings& settings) { settings.skin_texture = name; });
  EXPECT_NE(refusal({name}).find("cannot be read"), std::string::npos);
}

TEST_F(ForeignScene, ModelsOfNoKindAreRefused) {
  stored_.model.name = "no such";
  EXPECT_NE(refusal(), "");
  stored_.model.name = "torus", stored_.model.prepare.crease_degrees = std::numeric_limits<double>::infinity();
  EXPECT_NE(refusal(), "");
}

}  // namespace
}  // namespace pelage::foreign_scene_test
