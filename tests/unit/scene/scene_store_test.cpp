#include "server/scene/scene_store.h"

#include "base/limits.h"
#include "protocol/json/encode.h"
#include "server/builtin/builtin.h"
#include "server/history/journal.h"
#include "server/history/sqlite.h"
#include "server/import/import.h"
#include "server/scene/model.h"
#include "tests/unit/scene/store_fixture.h"

namespace pelage::scene_store_test {
namespace {

using SceneStoreTest = StoreTest;

TEST_F(SceneStoreTest, MakesFindsListsAndRemoves) {
  const auto a = make(), b = make(Builtin::plane, 100);
  EXPECT_EQ(a->id().size(), 12u);
  EXPECT_EQ(a->id().find_first_not_of("0123456789abcdef"), std::string::npos);
  EXPECT_NE(a->id(), b->id());
  EXPECT_EQ(*store_->find(a->id()), a);
  ASSERT_EQ(store_->list().size(), 2u);
  EXPECT_EQ(store_->list()[0].id, a->id());
  EXPECT_EQ(store_->list()[1].model, "plane");
  EXPECT_TRUE(store_->remove(a->id()).ok());
  EXPECT_EQ(store_->find(a->id()).status().code, Code::not_found);
  EXPECT_EQ(store_->remove(a->id()).code, Code::not_found);
  open();
  ASSERT_EQ(store_->list().size(), 1u);
}

TEST_F(SceneStoreTest, IsFullAtTheLimit) {
  for (std::size_t i = 0; i < limits::scenes; ++i) make(Builtin::plane, 2);
  EXPECT_EQ(store_->create({}).status().code, Code::conflict);
}

TEST_F(SceneStoreTest, ARestartHasEverything) {
  const auto scene = make();
  const std::string id = scene->id();
  SetCoat coat;
  coat.coat.root_share = 0.6;
  execute(*scene, {comb_at(*scene, 5)});
  execute(*scene, {coat});
  execute(*scene, {comb_at(*scene, 50)});
  execute(*scene, {comb_at(*scene, 51)});
  move(*scene, Undo{1});
  move(*scene, Revert{1});
  move(*scene, Undo{1});
  const SceneSummary before = scene->summary();
  const std::string log = encode(Log{scene->log()});
  const std::size_t effective = scene->effective_log().size();

  open();
  const auto again = *store_->find(id);
  const SceneSummary after = again->summary();
  EXPECT_EQ(after.name, "test");
  EXPECT_EQ(after.model, "torus");
  EXPECT_EQ(after.revision, 7u);
  EXPECT_EQ(after.revision, before.revision);
  EXPECT_EQ(after.fields_hash, before.fields_hash);
  EXPECT_EQ(after.undo_steps, before.undo_steps);
  EXPECT_EQ(after.redo_steps, before.redo_steps);
  EXPECT_EQ(encode(Log{again->log()}), log);
  EXPECT_EQ(again->effective_log().size(), effective);
  EXPECT_EQ(again->snapshot()->settings->coats[0].coat.root_share, 0.6);
  EXPECT_EQ(move(*again, Undo{3}).revision, 8u);
  EXPECT_EQ(hash(*again), hash(*make()));
  EXPECT_EQ(again->snapshot()->settings->coats[0].coat.root_share, Coat{}.root_share);
}

std::size_t eyes_of(const Scene& scene) {
  std::size_t count = 0;
  count = scene.snapshot()->settings->eyes.size();
  return count;
}

TEST_F(SceneStoreTest, ACreatureHasEyesThatARestartKeeps) {
  const std::string creature = make(Builtin::creature)->id(), torus = make()->id();
  const auto find = [&](const std::string& id) { return *store_->find(id); };
  EXPECT_EQ(eyes_of(*find(torus)), 0u);
  EXPECT_EQ(eyes_of(*find(creature)), 2u);
  open();
  EXPECT_EQ(eyes_of(*find(creature)), 2u);
  EXPECT_EQ(execute(*find(creature), {SetEyes{}}).revision, 1u);
  EXPECT_EQ(execute(*find(creature), {SetEyes{}}).revision, 1u);  // nothing changes
  execute(*find(torus), {SetEyes{{Eye{.position = {0, 1, 0}}}}});
  open();
  EXPECT_EQ(eyes_of(*find(creature)), 0u);
  EXPECT_EQ(eyes_of(*find(torus)), 1u);
  move(*find(creature), Undo{});
  EXPECT_EQ(eyes_of(*find(creature)), 2u);
}

TEST_F(SceneStoreTest, EyesFarFromTheModelAreRefused) {
  const auto scene = make();
  const Eye far{.position = {0, 1e20, 0}};
  const auto refused = scene->execute({SetEyes{{Eye{}, far}}});
  ASSERT_FALSE(refused.ok());
  EXPECT_EQ(refused.status().pointer, "/eyes/1/position");
}

std::vector<CurveGroup> curves_of(const Scene& scene) {
  std::vector<CurveGroup> groups;
  groups = scene.snapshot()->settings->curves;
  return groups;
}

TEST_F(SceneStoreTest, ACreatureHasWhiskersThatARestartKeeps) {
  const std::string creature = make(Builtin::creature)->id(), torus = make()->id();
  const auto find = [&](const std::string& id) { return *store_->find(id); };
  EXPECT_TRUE(curves_of(*find(torus)).empty());
  const std::vector<CurveGroup> first = curves_of(*find(creature));
  EXPECT_EQ(first.size(), 8u);  // two rows of whiskers, a brow and lashes on each side
  open();
  EXPECT_EQ(curves_of(*find(creature)), first);
  execute(*find(creature), {SetCurves{{first[0]}}});
  open();
  EXPECT_EQ(curves_of(*find(creature)), std::vector<CurveGroup>{first[0]});
  move(*find(creature), Undo{});
  EXPECT_EQ(curves_of(*find(creature)), first);
}

TEST_F(SceneStoreTest, ACreaturesWhiskersStandOutOfItsSkin) {
  const auto creature = make(Builtin::creature);
  const SnapshotPtr now = creature->snapshot();
  const SceneView view = now->view();
  const Surface& surface = view.model.surface;
  for (const CurveGroup& group : view.settings.curves) {
    for (const GuideCurve& curve : group.curves) {
      const glm::dvec3 root = surface.mesh().to_internal(curve.front()), tip = surface.mesh().to_internal(curve.back());
      EXPECT_LT(glm::distance(root, surface.position(surface.nearest(root))), 0.02);
      EXPECT_GT(glm::dot(tip - root, surface.normal(surface.nearest(root))), 0);
    }
  }
}

TEST_F(SceneStoreTest, CurvesFarFromTheModelAreRefused) {
  const auto scene = make();
  const CurveGroup near{.curves = {{{0, 1, 0}, {0, 2, 0}}}},
      far{.curves = {{{0, 1, 0}, {0, 2, 0}}, {{0, 1, 0}, {0, 1e20, 0}}}};
  const auto refused = scene->execute({SetCurves{{near, far}}});
  ASSERT_FALSE(refused.ok());
  EXPECT_EQ(refused.status().pointer, "/groups/1/curves/1/1");
}

std::size_t bare_regions_of(const Scene& scene) {
  std::size_t count = 0;
  count = scene.snapshot()->settings->skin.size();
  return count;
}

TEST_F(SceneStoreTest, ACreatureHasBareSkinThatUndoGivesBack) {
  const std::string creature = make(Builtin::creature)->id(), torus = make()->id();
  const auto find = [&](const std::string& id) { return *store_->find(id); };
  const std::size_t first = bare_regions_of(*find(creature));
  EXPECT_GT(first, 20u);
  EXPECT_EQ(bare_regions_of(*find(torus)), 0u);
  execute(*find(creature), {SetSkin{}});
  execute(*find(torus), {SetSkin{{SkinRegion{}, SkinRegion{.centre = {0, 0.1, 0}}}}});
  open();
  EXPECT_EQ(bare_regions_of(*find(creature)), 0u);
  EXPECT_EQ(bare_regions_of(*find(torus)), 2u);
  move(*find(creature), Undo{});
  EXPECT_EQ(bare_regions_of(*find(creature)), first);
}

TEST_F(SceneStoreTest, BareSkinFarFromTheModelIsRefused) {
  const auto scene = make();
  const auto refused = scene->execute({SetSkin{{SkinRegion{}, SkinRegion{.centre = {0, 1e20, 0}}}}});
  ASSERT_FALSE(refused.ok());
  EXPECT_EQ(refused.status().pointer, "/regions/1/centre");
}

TEST_F(SceneStoreTest, WhatWasAnsweredIsOnDiskWhenTheServerIsKilled) {
  const auto scene = make();
  for (std::size_t i = 0; i < 20; ++i) execute(*scene, {comb_at(*scene, 10 * i)});
  // A copy of the files is all that a killed server leaves.
  const std::filesystem::path left = folder_.string() + "_left";
  std::filesystem::remove_all(left);
  std::filesystem::copy(folder_, left);
  {
    const auto after = SceneStore::open(left.string(), "pelage-import");
    ASSERT_TRUE(after.ok()) << after.status().message;
    const auto again = (*after)->find(scene->id());
    ASSERT_TRUE(again.ok());
    EXPECT_EQ((*again)->revision(), 20u);
    EXPECT_EQ(hash(**again), hash(*scene));
  }
  std::filesystem::remove_all(left);
}

TEST_F(SceneStoreTest, ARestartInTheMiddleOfALiveStrokeKeepsWhatCame) {
  const auto scene = make();
  Comb part = comb_at(*scene, 5);
  part.stroke->id = "k";
  part.stroke->last = false;
  execute(*scene, {part});
  const FieldsHash combed = hash(*scene);
  const std::string id = scene->id();
  open();
  const auto again = *store_->find(id);
  EXPECT_EQ(hash(*again), combed);
  part.stroke->part = 1;
  EXPECT_EQ(again->execute({part}).status().limit, "the next part is 0");
  EXPECT_EQ(again->effective_log().size(), 1u);
}

TEST_F(SceneStoreTest, ARestartHasTheNewModel) {
  const auto scene = make();
  execute(*scene, {comb_at(*scene, 5)});
  const RawModel raw = make_builtin({Builtin::plane, 200});
  StoredModel stored{.name = "obj", .raw = encode_raw_model(raw)};
  const auto model = build_model(raw, stored, 77);
  ASSERT_TRUE(model.ok());
  ASSERT_TRUE(scene->replace_model(*model, {.length = 0.1}, stored).ok());
  execute(*scene, {comb_at(*scene, 5)});
  const SceneSummary before = scene->summary();
  open();
  const SceneSummary after = store_->list().at(0);
  EXPECT_EQ(after.revision, 3u);
  EXPECT_EQ(after.model, "obj");
  EXPECT_EQ(after.report.triangles, before.report.triangles);
  EXPECT_EQ(after.fields_hash, before.fields_hash);
}

TEST_F(SceneStoreTest, ADamagedSceneStandsBeforeTheDamageAndTheOthersAreWhole) {
  std::string bad, good;
  FieldsHash first;
  {
    const auto scene = make(), other = make();
    bad = scene->id(), good = other->id();
    for (const std::size_t vertex : {5, 50, 80}) {
      execute(*scene, {comb_at(*scene, vertex)});
      execute(*other, {comb_at(*other, vertex)});
      if (vertex == 5) first = hash(*scene);
    }
  }
  store_.reset();
  {
    auto database = Database::open((folder_ / "pelage.sqlite").string());
    ASSERT_TRUE(
        database
            ->execute(
                ("UPDATE entries SET hash_low = hash_low + 1 WHERE revision = 2 AND scene = '" + bad + "'").c_str())
            .ok());
  }
  open();
  ASSERT_EQ(store_->damages().size(), 1u);
  EXPECT_NE(store_->damages()[0].find(bad), std::string::npos);
  const auto scene = *store_->find(bad), other = *store_->find(good);
  EXPECT_EQ(scene->revision(), 1u);
  EXPECT_EQ(hash(*scene), first);
  EXPECT_NE(scene->summary().damage.find("revision 2"), std::string::npos);
  EXPECT_EQ(scene->execute({comb_at(*scene, 5)}).status().code, Code::conflict);
  EXPECT_EQ(scene->move(Undo{}).status().code, Code::conflict);
  EXPECT_EQ(store_->subdivide(*scene, {}).status().code, Code::conflict);
  const auto branch = store_->branch(*scene, {.name = "whole"});
  ASSERT_TRUE(branch.ok()) << branch.status().message;
  EXPECT_EQ(hash(**branch), first);
  execute(**branch, {comb_at(**branch, 9)});
  EXPECT_EQ(other->revision(), 3u);
  execute(*other, {comb_at(*other, 9)});
  ASSERT_TRUE(store_->remove(bad).ok());
  EXPECT_TRUE(store_->damages().empty());
}

TEST_F(SceneStoreTest, ASceneWhoseModelIsDamagedIsListedAndCanBeRemoved) {
  const std::string bad = make()->id(), good = make()->id();
  store_.reset();
  {
    auto database = Database::open((folder_ / "pelage.sqlite").string());
    ASSERT_TRUE(database->execute(("UPDATE scenes SET raw = raw || x'00' WHERE id = '" + bad + "'").c_str()).ok());
  }
  open();
  ASSERT_EQ(store_->list().size(), 2u);
  EXPECT_EQ(store_->list()[0].name, "test");
  EXPECT_NE(store_->list()[0].damage, "");
  EXPECT_EQ(store_->list()[1].damage, "");
  EXPECT_EQ(store_->find(bad).status().code, Code::conflict);
  EXPECT_TRUE(store_->find(good).ok());
  EXPECT_TRUE(store_->remove(bad).ok());
  EXPECT_EQ(store_->list().size(), 1u);
}

TEST_F(SceneStoreTest, AModelThatCannotBeReadLeavesTheSceneAsItWas) {
  const auto scene = make();
  const FieldsHash first = hash(*scene);
  const std::string bytes = "no model";
  const auto refused = store_->load_model(*scene, {}, std::as_bytes(std::span(bytes)));
  EXPECT_FALSE(refused.ok());
  EXPECT_EQ(scene->revision(), 0u);
  EXPECT_EQ(hash(*scene), first);
}

}  // namespace
}  // namespace pelage::scene_store_test
