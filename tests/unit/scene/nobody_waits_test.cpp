// Readers of a scene never wait for those who change, export or sync it.
#include <chrono>
#include <functional>
#include <future>
#include <string>

#include "server/builtin/builtin.h"
#include "server/history/journal.h"
#include "server/scene/model.h"
#include "tests/support/held.h"
#include "tests/unit/scene/store_fixture.h"

namespace pelage::nobody_waits_test {
namespace {

using testing::expect_ends, testing::hang_guard, testing::Held, testing::that_waits;

/// Reads everything that clients read of a scene's current state.
void expect_read(Scene& scene, Revision revision) {
  expect_ends("a reader", [&] {
    EXPECT_EQ(scene.snapshot()->revision, revision);
    EXPECT_TRUE(scene.pick({.nearest = glm::dvec3(0, 1, 0)})->hit);
    EXPECT_EQ(scene.summary().revision, revision);
    EXPECT_EQ(scene.settings()->revision, revision);
    EXPECT_EQ(scene.groom({})->revision, revision);
    EXPECT_EQ(scene.snapshot_at(0)->revision, 0u);
    EXPECT_EQ(scene.log().size(), scene.effective_log().size());
    EXPECT_EQ(scene.news({}).now.revision, revision);
    EXPECT_EQ(scene.wait_newer(revision, 0), revision);
    EXPECT_GT(scene.memory().own, 0u);
  });
}

class NobodyWaits : public StoreTest {
 protected:
  void SetUp() override {
    StoreTest::SetUp();
    scene_ = make(), other_ = make();
    execute(*scene_, {comb_at(*scene_, 5)});
  }
  void TearDown() override {
    scene_.reset(), other_.reset();
    StoreTest::TearDown();
  }
  void expect_all_read() const {
    expect_read(*scene_, 1), expect_read(*other_, 0);
    const auto listed = store_->list();
    ASSERT_EQ(listed.size(), 2u);
    EXPECT_EQ(listed[0].revision, 1u);
    EXPECT_EQ(listed[0].undo_steps, 1u);
    EXPECT_EQ(scene_->compare(0, 1)->fields.at(0).field, "direction");
  }

  std::shared_ptr<Scene> scene_, other_;
};

TEST_F(NobodyWaits, WhileACommandIsEvaluated) {
  Result<CommandAnswer> answer = failure(Code::internal, "not run");
  Held command([&](const std::function<void()>& middle) {
    answer = scene_->execute({comb_at(*scene_, 50)}, {.cancel = that_waits(middle)});
  });
  expect_all_read();
  execute(*other_, {comb_at(*other_, 5)});
  command.end();
  ASSERT_TRUE(answer.ok()) << answer.status().message;
  EXPECT_EQ(scene_->revision(), 2u);
}

TEST_F(NobodyWaits, WhileAnAmendmentIsReplayed) {
  Held amendment([&](const std::function<void()>& middle) {
    EXPECT_TRUE(scene_->amend({1, {comb_at(*scene_, 50)}}, {.cancel = that_waits(middle)}).ok());
  });
  expect_all_read();
}

TEST_F(NobodyWaits, WhileASceneIsExported) {
  const std::string file = (folder_ / "saved").string();
  Held copy([&](const std::function<void()>& middle) {
    const Result<Revision> saved = store_->save(*scene_, file, that_waits(middle, 0));
    EXPECT_TRUE(saved.ok());
    EXPECT_EQ(*saved, 1u);  // the state when the export began
  });
  expect_all_read();
  execute(*other_, {comb_at(*other_, 5)});
  auto change = std::async(std::launch::async, [&] { return execute(*scene_, {comb_at(*scene_, 50)}).revision; });
  ASSERT_EQ(change.wait_for(hang_guard), std::future_status::ready) << "a command waits for the copy";
  EXPECT_EQ(change.get(), 2u);
  copy.end();
  const auto saved = Journal::open(file);
  ASSERT_TRUE(saved.ok()) << saved.status().message;
  const auto entries = (*saved)->entries(scene_->id(), 0);
  ASSERT_TRUE(entries.ok()) << entries.status().message;
  EXPECT_EQ(entries->back().revision, 1u);
}

TEST_F(NobodyWaits, ARemovedSceneEndsItsCommand) {
  Result<CommandAnswer> answer = failure(Code::internal, "not run");
  Held command([&](const std::function<void()>& middle) {
    answer = scene_->execute({comb_at(*scene_, 50)}, {.cancel = that_waits(middle)});
  });
  expect_ends("a removal", [&] { EXPECT_TRUE(store_->remove(scene_->id()).ok()); });
  command.end();
  EXPECT_EQ(answer.status().code, Code::not_found);
}

TEST_F(NobodyWaits, NoMoreChangesWaitThanMayAndAllAreMade) {
  const auto change = [&] {
    for (;;) {
      const auto answer = scene_->execute({comb_at(*scene_, 5)});
      if (answer || answer.status().code != Code::busy) return answer.ok();
    }
  };
  std::vector<std::future<bool>> changes;
  Held command([&](const std::function<void()>& middle) {
    EXPECT_TRUE(scene_->execute({comb_at(*scene_, 50)}, {.cancel = that_waits(middle)}).ok());
  });
  for (std::size_t k = 0; k < ChangeTurns::max_waiting; ++k) changes.push_back(std::async(std::launch::async, change));
  expect_ends("a refusal", [&] {
    const ExecuteOptions nobody_waits{.cancel = Cancel([] { return true; })};
    while (scene_->execute({comb_at(*scene_, 5)}, nobody_waits).status().code != Code::busy) continue;
  });
  command.end();
  for (auto& made : changes) EXPECT_TRUE(made.get());
  EXPECT_EQ(scene_->revision(), 2 + ChangeTurns::max_waiting);
}

/// A slow sync holds a journal's lock while another scene is copied into it; only changes wait for it.
TEST(NobodyWaitsForASync, OfTheirSceneOrAnother) {
  const std::filesystem::path folder = std::filesystem::path(::testing::TempDir()) / "pelage_slow_sync";
  std::filesystem::remove_all(folder);
  std::filesystem::create_directories(folder);
  const auto open = [&](const char* name) { return std::move(Journal::open((folder / name).string())).value(); };
  const std::unique_ptr<Journal> journal = open("journal"), elsewhere = open("elsewhere");
  const RawModel raw = make_builtin({Builtin::torus, 1000});
  const StoredModel how{.name = "torus", .raw = encode_raw_model(raw)};
  const auto model = *build_model(raw, how, 1);
  const auto add = [&](const char* id, Journal& to) {
    auto scene = std::make_unique<Scene>(id, "fox", model, FirstGroom{}, to);
    const auto fields = scene->snapshot()->fields;
    const FieldDelta groom = difference(FieldSet(fields->size()), *fields);
    EXPECT_TRUE(to.add_scene({id, "fox", how, 0, groom}).ok());
    return scene;
  };
  const auto scene = add("a", *journal), other = add("b", *journal), copied = add("c", *elsewhere);
  const auto change = [](Scene& of, double ambient) {
    SetLook look;
    look.look.ambient = ambient;
    return of.execute({look});
  };
  ASSERT_TRUE(change(*copied, 0.1).ok());
  std::future<Result<CommandAnswer>> answer;
  {
    Held sync([&](const std::function<void()>& middle) {
      EXPECT_TRUE(elsewhere->copy_scene("c", newest_revision, *journal, "d", "copy", middle).ok());
    });
    answer = std::async(std::launch::async, [&] { return change(*scene, 0.2); });
    EXPECT_EQ(answer.wait_for(std::chrono::milliseconds(200)), std::future_status::timeout) << "it is not on disk yet";
    expect_read(*scene, 0), expect_read(*other, 0);
  }
  EXPECT_TRUE(answer.get().ok());
  EXPECT_EQ(scene->revision(), 1u);
  std::filesystem::remove_all(folder);
}

}  // namespace
}  // namespace pelage::nobody_waits_test
