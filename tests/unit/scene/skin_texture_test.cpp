// Skin textures of scenes: named in the log, stored in the journal, undone like every change.
#include "protocol/json/names.h"
#include "server/builtin/builtin.h"
#include "server/history/journal.h"
#include "server/history/sqlite.h"
#include "server/import/import.h"
#include "server/scene/model.h"
#include "tests/support/textured.h"
#include "tests/unit/scene/store_fixture.h"

namespace pelage::skin_texture_test {
namespace {

using testing::red_and_blue;

const RawImage green{1, 1, {0, 255, 0, 255}};

class SkinTextureTest : public StoreTest {
 protected:
  /// A scene whose model has texture coordinates.
  std::shared_ptr<Scene> make_textured(FurPatches fur_patches = FurPatches::overlapping) {
    const auto scene = make(Builtin::plane, 100);
    const RawModel raw = testing::with_planar_uvs(make_builtin({Builtin::sphere, 300}));
    const StoredModel stored{.name = "obj", .raw = encode_raw_model(raw), .fur_patches = fur_patches};
    const auto model = build_model(raw, stored, ++last_model_);
    EXPECT_TRUE(model.ok());
    EXPECT_TRUE(scene->replace_model(*model, {}, stored).ok());
    return scene;
  }
  /// The bytes of the skin texture that frames of the scene use; empty for the model's own colours.
  static std::vector<std::uint8_t> picture_of(const Scene& scene) {
    std::vector<std::uint8_t> bytes;
    const SnapshotPtr now = scene.snapshot();
    const SceneView view = now->view();
    if (view.skin_texture) bytes = view.skin_texture->rgba;
    return bytes;
  }
  static std::string name_in(const Scene& scene) {
    std::string name;
    name = scene.snapshot()->settings->skin_texture;
    return name;
  }
  std::uint64_t pictures() {
    store_.reset();
    std::uint64_t count = 0;
    {
      auto database = Database::open((folder_ / "pelage.sqlite").string());
      Statement question = database->prepare("SELECT count(*) FROM pictures");
      EXPECT_TRUE(question.step().ok());
      count = question.number_at(0);
    }
    open();
    return count;
  }

  std::uint64_t last_model_ = 1000;
};

TEST_F(SkinTextureTest, AModelWithoutTextureCoordinatesIsRefused) {
  const auto scene = make(Builtin::sphere, 300);
  const auto answer = store_->store_skin_texture(*scene, green);
  ASSERT_FALSE(answer.ok());
  EXPECT_EQ(answer.status().code, Code::invalid);
  EXPECT_EQ(answer.status().pointer, "/picture");
  EXPECT_NE(answer.status().message.find("no texture coordinates"), std::string::npos);
  EXPECT_EQ(answer.status().limit, "a model with texture coordinates; or own, which takes a picture off");
  EXPECT_EQ(scene->revision(), 0u);
}

TEST_F(SkinTextureTest, AnUnknownPictureIsRefused) {
  const auto scene = make_textured();
  const auto answer = scene->execute({SetSkinTexture{std::string(32, '0')}});
  ASSERT_FALSE(answer.ok());
  EXPECT_EQ(answer.status().pointer, "/picture");
  const auto batch = scene->execute({comb_at(*scene, 5), SetSkinTexture{std::string(32, '0')}});
  EXPECT_EQ(batch.status().pointer, "/commands/1/picture");
}

TEST_F(SkinTextureTest, UndoRedoAndRevertBringPictures) {
  const auto scene = make_textured();
  EXPECT_EQ(store_->store_skin_texture(*scene, red_and_blue())->revision, 2u);
  EXPECT_EQ(store_->store_skin_texture(*scene, green)->revision, 3u);
  EXPECT_EQ(store_->store_skin_texture(*scene, green)->revision, 3u) << "the same picture changes nothing";
  EXPECT_EQ(picture_of(*scene), green.rgba);
  move(*scene, Undo{1});
  EXPECT_EQ(picture_of(*scene), red_and_blue().rgba);
  move(*scene, Undo{1});
  EXPECT_TRUE(picture_of(*scene).empty());
  move(*scene, Redo{2});
  EXPECT_EQ(picture_of(*scene), green.rgba);
  move(*scene, Revert{2});
  EXPECT_EQ(picture_of(*scene), red_and_blue().rgba);
  execute(*scene, {SetSkinTexture{}});
  EXPECT_TRUE(picture_of(*scene).empty());
}

TEST_F(SkinTextureTest, ARestartHasThePictureAndThoseThatUndoNeeds) {
  const std::string id = make_textured()->id();
  store_->store_skin_texture(**store_->find(id), red_and_blue()).value();
  store_->store_skin_texture(**store_->find(id), green).value();
  open();
  const auto again = *store_->find(id);
  EXPECT_EQ(picture_of(*again), green.rgba);
  move(*again, Undo{1});
  EXPECT_EQ(picture_of(*again), red_and_blue().rgba);
}

TEST_F(SkinTextureTest, TheLogReplaysOnAnotherScene) {
  const auto scene = make_textured(), other = make_textured();
  store_->store_skin_texture(*scene, red_and_blue()).value();
  for (const std::vector<Command>& step : scene->effective_log()) execute(*other, step);
  EXPECT_EQ(picture_of(*other), red_and_blue().rgba);
  EXPECT_EQ(name_in(*other), name_in(*scene));
}

TEST_F(SkinTextureTest, NamesFollowThePixels) {
  const auto scene = make_textured();
  RawImage turned = red_and_blue();
  turned.width = 1, turned.height = 2;
  std::vector<std::string> names;
  for (const RawImage& image : {red_and_blue(), green, turned}) {
    store_->store_skin_texture(*scene, image).value();
    names.push_back(name_in(*scene));
    EXPECT_EQ(names.back().size(), 32u);
  }
  EXPECT_NE(names[0], names[1]);
  EXPECT_NE(names[0], names[2]);
}

TEST_F(SkinTextureTest, PicturesGoWithTheLastLogThatNamesThem) {
  const std::string a = make_textured()->id(), b = make_textured()->id();
  const auto find = [&](const std::string& id) { return *store_->find(id); };
  store_->store_skin_texture(*find(a), red_and_blue()).value();
  store_->store_skin_texture(*find(a), green).value();
  store_->store_skin_texture(*find(b), green).value();
  EXPECT_EQ(pictures(), 2u);
  ASSERT_TRUE(store_->remove(a).ok());
  EXPECT_EQ(pictures(), 1u);
  EXPECT_EQ(picture_of(*find(b)), green.rgba);
  const RawModel raw = make_builtin({Builtin::plane, 2});
  const StoredModel stored{.name = "obj", .raw = encode_raw_model(raw)};
  ASSERT_TRUE(find(b)->replace_model(*build_model(raw, stored, 77), {}, stored).ok());
  EXPECT_TRUE(picture_of(*find(b)).empty());
  EXPECT_EQ(pictures(), 0u);
}

TEST_F(SkinTextureTest, AMissingPictureIsReported) {
  store_->store_skin_texture(*make_textured(), green).value();
  store_.reset();
  {
    auto database = Database::open((folder_ / "pelage.sqlite").string());
    ASSERT_TRUE(database->execute("UPDATE pictures SET bytes = x'00'").ok());
  }
  open();
  ASSERT_EQ(store_->damages().size(), 1u);
  EXPECT_NE(store_->damages()[0].find("picture"), std::string::npos);
  EXPECT_EQ((*store_->find(store_->list()[0].id))->execute({SetGround{}}).status().code, Code::conflict);
}

std::size_t patch_triangles_of(const Scene& scene) {
  return scene.snapshot()->view().model.patches.patch_triangles.size();
}

TEST_F(SkinTextureTest, FurIsLaidAsTheModelWasAskedFor) {
  for (const FurPatches how : {FurPatches::overlapping, FurPatches::hard, FurPatches::own_uvs}) {
    const auto scene = make_textured(how);
    const std::size_t triangles = scene->summary().report.triangles, patch_triangles = patch_triangles_of(*scene);
    if (how == FurPatches::overlapping)
      EXPECT_GT(patch_triangles, triangles);
    else
      EXPECT_EQ(patch_triangles, triangles);
    std::uint32_t patches = 0;
    patches = scene->snapshot()->view().model.patches.patches;
    if (how == FurPatches::own_uvs)
      EXPECT_EQ(patches, 1u) << "one island of texture coordinates";
    else
      EXPECT_GT(patches, 1u);
    const std::string id = scene->id();
    open();
    EXPECT_EQ(patch_triangles_of(**store_->find(id)), patch_triangles) << "after a restart";
    EXPECT_EQ((*store_->find(id))->summary().fur_patches, json_names::word_of(json_names::fur_patches, how));
  }
}

TEST_F(SkinTextureTest, ABuiltinIsLaidByPatchesOnly) {
  const auto hard = store_->create({"test", {Builtin::sphere, 500}, {}, FurPatches::hard});
  ASSERT_TRUE(hard.ok());
  EXPECT_EQ(patch_triangles_of(**hard), (*hard)->summary().report.triangles);
  const auto own = store_->create({"test", {Builtin::sphere, 500}, {}, FurPatches::own_uvs});
  ASSERT_FALSE(own.ok());
  EXPECT_EQ(own.status().code, Code::invalid);
  EXPECT_EQ(own.status().pointer, "/fur_patches");
}

}  // namespace
}  // namespace pelage::skin_texture_test
