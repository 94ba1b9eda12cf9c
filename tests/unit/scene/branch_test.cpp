#include <thread>

#include "base/limits.h"
#include "protocol/json/encode.h"
#include "server/frames/shown_scene.h"
#include "tests/unit/scene/store_fixture.h"

namespace pelage::branch_test {
namespace {

class BranchTest : public StoreTest {
 protected:
  std::shared_ptr<Scene> branch(const Scene& from, std::optional<Revision> at = {}) const {
    const auto scene = store_->branch(from, {"side", at});
    EXPECT_TRUE(scene.ok()) << scene.status().message;
    return scene.ok() ? *scene : nullptr;
  }
  static std::uint64_t copy_of(const Scene& scene) {
    std::uint64_t id = 0;
    id = scene.snapshot()->view().copy_id;
    return id;
  }
  static const SceneModel* model_of(const Scene& scene) {
    const SceneModel* model = nullptr;
    model = &scene.snapshot()->view().model;
    return model;
  }
  static std::string log_of(const Scene& scene) { return encode(Log{scene.log()}); }
};

TEST_F(BranchTest, BeginsAsTheSceneIs) {
  const auto scene = make();
  SetCoat coat;
  coat.coat.root_share = 0.6;
  execute(*scene, {comb_at(*scene, 5)});
  execute(*scene, {coat, Checkpoint{"combed", {}}});
  execute(*scene, {comb_at(*scene, 50)});
  move(*scene, Undo{});
  const auto side = branch(*scene);
  const SceneSummary a = scene->summary(), b = side->summary();
  EXPECT_NE(b.id, a.id);
  EXPECT_EQ(b.name, "side");
  EXPECT_EQ(b.model, a.model);
  EXPECT_EQ(b.revision, 4u);
  EXPECT_EQ(b.fields_hash, a.fields_hash);
  EXPECT_EQ(b.undo_steps, 2u);
  EXPECT_EQ(b.redo_steps, 1u);
  EXPECT_EQ(log_of(*side), log_of(*scene));
  const SnapshotPtr now = side->snapshot();
  const SceneView view = now->view();
  EXPECT_EQ(view.settings.coats[0].coat.root_share, 0.6);
  ASSERT_EQ(view.settings.checkpoints.size(), 1u);
  EXPECT_EQ(view.settings.checkpoints[0].revision, 2u);
  EXPECT_EQ(model_of(*side), model_of(*scene)) << "the model is shared";
  EXPECT_NE(copy_of(*side), copy_of(*scene)) << "the renderer's copies are not: their fields differ";
  EXPECT_EQ(store_->list().size(), 2u);
  EXPECT_EQ(move(*side, Redo{}).fields_hash, move(*scene, Redo{}).fields_hash);
}

TEST_F(BranchTest, NeitherTouchesTheOther) {
  const auto scene = make();
  execute(*scene, {comb_at(*scene, 5)});
  const auto side = branch(*scene);
  const FieldsHash begun = hash(*scene);
  execute(*side, {comb_at(*side, 50)});
  EXPECT_EQ(hash(*scene), begun);
  EXPECT_EQ(scene->revision(), 1u);
  move(*scene, Undo{});
  EXPECT_EQ(side->revision(), 2u);
  EXPECT_TRUE(store_->remove(scene->id()).ok());
  EXPECT_EQ(move(*side, Undo{}).fields_hash, begun);
  open(0);  // keeps no step in memory
  const auto again = *store_->find(side->id());
  EXPECT_EQ(hash(*again), begun);
  EXPECT_EQ(move(*again, Undo{}).fields_hash, hash(*make()));
}

TEST_F(BranchTest, BeginsAtAnyRevision) {
  const auto scene = make();
  std::vector<FieldsHash> hashes{hash(*scene)};
  for (const std::size_t vertex : {5, 50, 90}) hashes.push_back(execute(*scene, {comb_at(*scene, vertex)}).fields_hash);
  for (Revision r = 0; r < hashes.size(); ++r) {
    const auto side = branch(*scene, r);
    EXPECT_EQ(side->revision(), r);
    EXPECT_EQ(hash(*side), hashes[r]);
    EXPECT_EQ(side->summary().undo_steps, r);
    EXPECT_EQ(side->effective_log().size(), r);
    const auto twig = branch(*side);
    EXPECT_EQ(log_of(*twig), log_of(*side));
    EXPECT_EQ(hash(*twig), hashes[r]);
  }
  const auto refused = store_->branch(*scene, {"side", 4});
  ASSERT_FALSE(refused.ok());
  EXPECT_EQ(refused.status().code, Code::invalid);
  EXPECT_EQ(refused.status().pointer, "/revision");
  EXPECT_EQ(refused.status().limit, "[0, 3]");
}

TEST_F(BranchTest, AStrokeThatIsUnderWayIsNotInTheBranch) {
  const auto scene = make();
  Comb part = comb_at(*scene, 7);
  part.stroke->id = "pen", part.stroke->last = false;
  execute(*scene, {part});
  const auto side = branch(*scene);
  EXPECT_EQ(hash(*side), hash(*scene));
  part.stroke->part = 1;
  EXPECT_EQ(side->execute({part}).status().pointer, "/stroke/part");
  EXPECT_TRUE(scene->execute({part}).ok()) << "it goes on where it began";
}

TEST_F(BranchTest, AnAmendmentCanBeBranchedInItsMidst) {
  const auto scene = make();
  const Comb first = comb_at(*scene, 5), second = comb_at(*scene, 50), third = comb_at(*scene, 90);
  execute(*scene, {first});
  execute(*scene, {second});
  const FieldsHash before = hash(*scene);
  ASSERT_TRUE(scene->amend({1, {third}}).ok());
  const auto side = branch(*scene, 4);  // after the revert and the first of two replayed steps
  EXPECT_EQ(side->effective_log().size(), 1u);
  EXPECT_EQ(move(*side, Undo{}).fields_hash, before);
  EXPECT_EQ(side->effective_log().size(), 2u);
}

TEST_F(BranchTest, IsRefusedAtTheLimitOfScenesAndForARemovedScene) {
  const auto scene = make(Builtin::plane, 2);
  const auto gone = make(Builtin::plane, 2);
  ASSERT_TRUE(store_->remove(gone->id()).ok());
  EXPECT_EQ(store_->branch(*gone, {}).status().code, Code::not_found);
  for (std::size_t i = 1; i < limits::scenes; ++i) branch(*scene);
  EXPECT_EQ(store_->branch(*scene, {}).status().code, Code::conflict);
  EXPECT_EQ(store_->list().size(), limits::scenes);
}

TEST_F(BranchTest, SnapshotsAreThoseOfTheirRevision) {
  const auto scene = make();
  std::vector<FieldsHash> hashes{hash(*scene)};
  for (const std::size_t vertex : {5, 50, 90}) hashes.push_back(execute(*scene, {comb_at(*scene, vertex)}).fields_hash);
  for (Revision r = 0; r < hashes.size(); ++r) {
    const auto past = scene->snapshot_at(r);
    ASSERT_TRUE(past.ok());
    EXPECT_EQ(past->fields->hash(), hashes[r]);
    EXPECT_EQ(past->model.get(), model_of(*scene));
  }
  EXPECT_EQ(scene->snapshot_at(4, "/overlay_from").status().pointer, "/overlay_from");
}

TEST_F(BranchTest, CanBeTakenWhileTheSceneChanges) {
  const auto scene = make();
  std::thread artist([&] {
    for (std::size_t i = 0; i < 60; ++i) {
      execute(*scene, {comb_at(*scene, 7 * i)});
      if (i % 20 == 19) {
        EXPECT_TRUE(scene->amend({scene->revision() - 5, {}}).ok());
      }
    }
  });
  std::vector<std::shared_ptr<Scene>> sides;
  for (int i = 0; i < 20; ++i) {
    sides.push_back(branch(*scene));
    const auto past = scene->snapshot_at(sides.back()->revision());
    EXPECT_TRUE(past.ok() && past->fields->hash() == hash(*sides.back()));
  }
  artist.join();
  for (const auto& side : sides) {
    const auto past = scene->snapshot_at(side->revision());
    ASSERT_TRUE(past.ok());
    EXPECT_EQ(past->fields->hash(), hash(*side)) << side->revision();
  }
}

TEST(ChangeShares, AreOfWhatCountsAsMuch) {
  FieldSet from(5);
  for (std::uint32_t v = 0; v < 5; ++v) from.set(v, {{0.5f, 0}, 0.02f, 0});
  FieldSet to = from;
  to.set(1, {{-0.5f, 0}, 0.02f, 0});                        // turned to the opposite side
  to.set(2, {{0.5f, 0.25f}, 0.04f, 0});                     // by half the longest fur, and by a quarter of a direction
  to.set(Field::width, 3, glm::vec4(2, 0, 0, 0));           // by 1 of a range of 4
  to.set(Field::root_colour, 3, glm::vec4(0.1f, 0, 0, 0));  // by less than the width
  to.set(Field::stretch, 4, glm::vec4(1e-6f, 0, 0, 0));     // by almost nothing
  const std::vector<float> shares = change_shares(from, to);
  EXPECT_EQ(shares[0], 0);
  EXPECT_EQ(shares[1], 1);
  EXPECT_FLOAT_EQ(shares[2], 0.5f);
  EXPECT_FLOAT_EQ(shares[3], 0.25f);
  EXPECT_GT(shares[4], 0);
  EXPECT_LT(shares[4], 0.001f);
  EXPECT_EQ(change_shares(to, from), shares) << "either way";
  for (const float share : change_shares(from, from)) EXPECT_EQ(share, 0);
}

TEST(ChangeShares, ExtremesStayInRange) {
  FieldSet from(2), to(2);
  for (std::size_t f = 0; f < field_count; ++f) {
    from.set(field_at(f), 0, glm::vec4(f == 0 ? 0 : field_shapes[f].min));
    to.set(field_at(f), 0, f == 0 ? glm::vec4(1, 0, 0, 0) : glm::vec4(field_shapes[f].max));
  }
  EXPECT_EQ(change_shares(from, to), (std::vector<float>{1, 0}));
  EXPECT_EQ(change_shares(FieldSet(3), FieldSet(3)), (std::vector<float>{0, 0, 0})) << "no fur at all";
}

}  // namespace
}  // namespace pelage::branch_test
