// Copies of scenes at earlier revisions: what they show, how long they are cached, and when they are evicted.
#include "server/frames/past_scenes.h"

#include <thread>

#include "server/history/history.h"
#include "tests/unit/scene/store_fixture.h"

namespace pelage::past_scenes_test {
namespace {

class PastScenesTest : public StoreTest {
 protected:
  SnapshotPtr find(const std::shared_ptr<Scene>& scene, Revision revision) {
    const Result<SnapshotPtr> copy = past_.find(*scene, revision);
    EXPECT_TRUE(copy.ok()) << copy.status().message;
    return copy.ok() ? *copy : nullptr;
  }
  static std::uint64_t present(const Scene& scene) { return scene.memory().copy_id; }
  /// A scene at revision 3.
  std::shared_ptr<Scene> groomed() const {
    const auto scene = make();
    execute(*scene, {comb_at(*scene, 5)});
    execute(*scene, {SetLights{}});
    execute(*scene, {comb_at(*scene, 50)});
    return scene;
  }

  PastScenes past_;
};

TEST_F(PastScenesTest, ShowWhatTheSceneWas) {
  const auto scene = make();
  std::vector<FieldsHash> hashes{hash(*scene)};
  const auto did = [&](const CommandAnswer& answer) { hashes.push_back(answer.fields_hash); };
  did(execute(*scene, {comb_at(*scene, 5)}));
  did(execute(*scene, {SetLights{}}));
  did(move(*scene, Undo{2}));
  did(execute(*scene, {comb_at(*scene, 50)}));
  for (Revision r = 0; r + 1 < hashes.size(); ++r) {
    const SnapshotPtr copy = find(scene, r);
    ASSERT_TRUE(copy);
    const SceneView view = copy->view();
    EXPECT_EQ(view.revision, r);
    EXPECT_EQ(view.fields.hash(), hashes[r]);
    EXPECT_EQ(view.settings.lights.empty(), r == 2);
    EXPECT_EQ(&view.model, scene->model().get());
    EXPECT_NE(view.copy_id, present(*scene));
  }
  EXPECT_EQ(find(scene, hashes.size() - 1), scene->snapshot()) << "the present needs no copy";
}

TEST_F(PastScenesTest, AreRefusedWhereTheModelHasNoSuchRevision) {
  const auto scene = groomed();
  EXPECT_EQ(past_.find(*scene, 4).status().pointer, "/revision");
  EXPECT_EQ(past_.find(*scene, 4).status().code, Code::invalid);
  find(scene, 1);
  ASSERT_TRUE(store_->subdivide(*scene, {}).ok());
  EXPECT_EQ(past_.find(*scene, 1).status().pointer, "/revision");
}

TEST_F(PastScenesTest, TheLastOnesAreKept) {
  const auto scene = groomed(), other = groomed();
  const SnapshotPtr first = find(scene, 0);
  EXPECT_EQ(find(scene, 0), first);
  const std::weak_ptr<const SceneSnapshot> second = find(other, 0);
  EXPECT_FALSE(second.expired());
  EXPECT_EQ(find(scene, 0), first);
  find(scene, 2);
  EXPECT_TRUE(second.expired()) << "it was asked for longest ago";
  EXPECT_EQ(find(scene, 0), first);
  EXPECT_EQ(past_.cached(present(*scene)).size(), PastScenes::max_cached);
  EXPECT_TRUE(past_.cached(present(*other)).empty());
}

TEST_F(PastScenesTest, TheRendererHearsOfThoseThatNobodyHolds) {
  const auto scene = groomed();
  SnapshotPtr held = find(scene, 0);
  const std::uint64_t held_id = held->view().copy_id, other_id = find(scene, 1)->view().copy_id;
  EXPECT_FALSE(past_.has_released());
  past_.forget(present(*scene) + 1000);
  EXPECT_FALSE(past_.has_released());
  past_.forget(present(*scene));
  EXPECT_TRUE(past_.has_released());
  EXPECT_EQ(past_.take_released(), std::vector{other_id});
  EXPECT_FALSE(past_.has_released()) << "a frame still draws the other";
  held.reset();
  EXPECT_EQ(past_.take_released(), std::vector{held_id});
  EXPECT_NE(find(scene, 0)->view().copy_id, held_id) << "the renderer is to forget that one";
}

TEST_F(PastScenesTest, OfARemovedSceneNoneAreKept) {
  const auto scene = groomed();
  find(scene, 0);
  const std::uint64_t id = present(*scene);
  ASSERT_TRUE(store_->remove(scene->id()).ok());
  past_.forget(id);
  EXPECT_FALSE(past_.find(*scene, 1).ok());
  EXPECT_TRUE(past_.cached(id).empty());
}

TEST_F(PastScenesTest, CanBeAskedForFromManyThreadsWhileTheSceneChanges) {
  const auto scene = groomed();
  const FieldsHash first = find(scene, 0)->view().fields.hash();
  std::vector<std::thread> threads;
  for (int t = 0; t < 3; ++t) {
    threads.emplace_back([&, t] {
      for (int i = 0; i < 30; ++i) {
        EXPECT_EQ(find(scene, 0)->view().fields.hash(), first);
        find(scene, static_cast<Revision>((t + i) % 3));
        past_.take_released();
      }
    });
  }
  for (std::size_t i = 0; i < 20; ++i) execute(*scene, {comb_at(*scene, 7 * i)});
  for (std::thread& thread : threads) thread.join();
  EXPECT_EQ(past_.cached(present(*scene)).size(), PastScenes::max_cached);
}

}  // namespace
}  // namespace pelage::past_scenes_test
