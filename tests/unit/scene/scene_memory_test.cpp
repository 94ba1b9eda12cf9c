// Scenes that are evicted for others and reopened.
#include <algorithm>
#include <future>
#include <map>

#include "protocol/json/encode.h"
#include "tests/unit/scene/store_fixture.h"

namespace pelage::scene_memory_test {
namespace {

class SceneMemoryTest : public StoreTest {
 protected:
  /// Makes a scene with two steps that nobody holds. Returns its id.
  std::string make_groomed(std::size_t seed = 5) const {
    const auto scene = make();
    execute(*scene, {comb_at(*scene, seed)});
    execute(*scene, {comb_at(*scene, seed + 40)});
    return scene->id();
  }
  /// Reopens the store with room for this number of such scenes.
  void open_for(std::size_t scenes) {
    const std::string id = make_groomed();
    const std::size_t bytes = store_->memory().bytes;
    ASSERT_TRUE(store_->remove(id).ok());
    open(limits::undo_bytes, scenes * bytes + bytes / 2);
  }
  void use(const std::string& id) const { ASSERT_TRUE(store_->find(id).ok()); }
};

TEST_F(SceneMemoryTest, TheLeastRecentlyUsedIsEvictedAndStaysListed) {
  open_for(2);
  std::vector<std::uint64_t> closed;
  store_->on_close([&](std::uint64_t copy) { closed.push_back(copy); });
  const std::string a = make_groomed(), b = make_groomed(9);
  use(a);
  const std::string c = make_groomed(20);
  use(c);
  MemoryUse memory = store_->memory();
  EXPECT_EQ(memory.open, 2u);
  EXPECT_EQ(memory.evicted, 1u);
  EXPECT_LE(memory.bytes, memory.budget);
  EXPECT_EQ(closed.size(), 1u);
  const std::vector<SceneSummary> listed = store_->list();
  ASSERT_EQ(listed.size(), 3u);
  EXPECT_EQ(listed[1].id, b);
  EXPECT_EQ(listed[1].undo_steps, 2u);
  use(a);
  EXPECT_EQ(store_->memory().reopened, 0u) << "a was used after b";
  use(b);
  memory = store_->memory();
  EXPECT_EQ(memory.reopened, 1u);
  EXPECT_EQ(memory.open, 2u);
}

TEST_F(SceneMemoryTest, TheRenderersCopiesCount) {
  open_for(2);
  std::map<std::uint64_t, std::size_t> copies;
  store_->on_close([&](std::uint64_t copy) { copies.erase(copy); });
  store_->count_copies([&](std::uint64_t copy) { return copies.contains(copy) ? copies[copy] : 0; });
  const std::string a = make_groomed(), b = make_groomed(9);
  const std::size_t bare = store_->memory().bytes;
  EXPECT_EQ(store_->memory().open, 2u);
  const auto copy_of = [&](const std::string& id) { return (*store_->find(id))->memory().copy_id; };
  const std::uint64_t first = copy_of(a), second = copy_of(b);
  copies = {{first, bare}, {second, bare}};  // as if both were drawn
  EXPECT_EQ(store_->memory().copies, 2 * bare);
  EXPECT_EQ(store_->memory().bytes, 3 * bare);
  use(b);
  EXPECT_EQ(store_->memory().open, 1u);
  EXPECT_EQ(copies.size(), 1u);
  EXPECT_EQ(store_->memory().copies, bare);
}

TEST_F(SceneMemoryTest, AnEvictedSceneIsAsItWas) {
  open_for(1);
  const std::string a = make_groomed();
  const SceneSummary before = (*store_->find(a))->summary();
  const std::string log = encode(Log{(*store_->find(a))->log()});
  const std::string b = make_groomed(9);
  use(b);
  ASSERT_EQ(store_->memory().evicted, 1u);
  const auto again = *store_->find(a);
  EXPECT_EQ(store_->memory().reopened, 1u);
  EXPECT_EQ(encode(again->summary()), encode(before));
  EXPECT_EQ(encode(Log{again->log()}), log);
  move(*again, Undo{2});
  EXPECT_EQ(hash(*again), hash(*make()));
  EXPECT_EQ(move(*again, Redo{2}).fields_hash, before.fields_hash);
}

TEST_F(SceneMemoryTest, AHeldSceneStays) {
  open_for(1);
  const auto held = *store_->find(make_groomed());
  const std::string b = make_groomed(9);
  use(b);
  use(make_groomed(20));
  EXPECT_EQ(*store_->find(held->id()), held);
  EXPECT_EQ(store_->memory().reopened, 0u);
  EXPECT_EQ(store_->memory().evicted, 2u);
}

TEST_F(SceneMemoryTest, AnEvictedSceneCanBeRemoved) {
  open_for(1);
  const std::string a = make_groomed(), b = make_groomed(9);
  use(b);
  ASSERT_EQ(store_->memory().evicted, 1u);
  EXPECT_TRUE(store_->remove(a).ok());
  EXPECT_EQ(store_->memory().reopened, 0u);
  EXPECT_EQ(store_->find(a).status().code, Code::not_found);
  open();
  ASSERT_EQ(store_->list().size(), 1u);
  EXPECT_EQ(store_->list()[0].id, b);
}

TEST_F(SceneMemoryTest, ManyWhoAskAtOnceOpenItOnce) {
  open_for(1);
  const std::string a = make_groomed(), b = make_groomed(9);
  use(b);
  std::vector<std::future<std::shared_ptr<Scene>>> asked;
  for (int i = 0; i < 8; ++i) asked.push_back(std::async(std::launch::async, [&] { return *store_->find(a); }));
  std::vector<std::shared_ptr<Scene>> found;
  for (auto& one : asked) found.push_back(one.get());
  EXPECT_EQ(std::count(found.begin(), found.end(), found[0]), 8);
  EXPECT_EQ(store_->memory().reopened, 1u);
}

TEST_F(SceneMemoryTest, ARestartHasEvictedScenesTooAndKeepsToTheBudget) {
  open_for(2);
  const std::size_t budget = store_->memory().budget;
  for (std::size_t i = 0; i < 5; ++i) make_groomed(7 * i);
  const auto text = [&] {
    std::string all;
    for (const SceneSummary& scene : store_->list()) all += encode(scene);
    return all;
  };
  const std::string before = text();
  open(limits::undo_bytes, budget);
  EXPECT_EQ(text(), before);
  EXPECT_EQ(store_->memory().evicted, 3u);
}

TEST_F(SceneMemoryTest, ASceneInTheMiddleOfAStrokeGoesLast) {
  open_for(2);
  const std::string a = make_groomed();
  Comb part = comb_at(**store_->find(a), 5);
  part.stroke->id = "k", part.stroke->last = false;
  execute(**store_->find(a), {part});
  use(make_groomed(9));
  use(make_groomed(20));
  part.stroke->part = 1;
  EXPECT_EQ(execute(**store_->find(a), {part}).revision, 4u);
  EXPECT_EQ(store_->memory().reopened, 0u);
}

TEST_F(SceneMemoryTest, BranchesCountTheirModelOnce) {
  const auto scene = make();
  const std::size_t one = store_->memory().bytes;
  const auto side = store_->branch(*scene, {"side", {}});
  ASSERT_TRUE(side.ok());
  EXPECT_LT(store_->memory().bytes, one + one / 2);
}

}  // namespace
}  // namespace pelage::scene_memory_test
