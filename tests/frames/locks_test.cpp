// Scenes do not wait for each other: while one runs a long command, one is exported and the disk takes no change of a
// third, frames of a fourth are drawn as usual.
#include <mutex>

#include "server/export/export_file.h"
#include "server/frames/picture_service.h"
#include "server/frames/scene_tracer.h"
#include "tests/support/failing_disk.h"
#include "tests/support/furred_model.h"
#include "tests/support/held.h"
#include "tests/unit/scene/store_fixture.h"

namespace pelage::testing::locks_test {
namespace {

class Locks : public StoreTest {
 protected:
  void SetUp() override {
    StoreTest::SetUp();
    frames_ = std::move(FrameService::start(without_gl, 2, gate_)).value();
    traces_ = std::make_unique<TraceQueue>(std::make_unique<SceneTracer>(*frames_, 2, std::size_t{1} << 30), gate_);
    pictures_ = std::make_unique<PictureService>(*frames_, *traces_);
    for (auto* scene : {&commanded_, &exported_, &written_, &seen_}) *scene = groomed();
  }
  void TearDown() override {
    for (auto* scene : {&commanded_, &exported_, &written_, &seen_}) scene->reset();
    pictures_.reset(), traces_.reset(), frames_.reset();
    StoreTest::TearDown();
  }
  std::shared_ptr<Scene> groomed() const {
    auto scene = make();
    execute(*scene, {SetCoat{.coat = coarse(Coat())}});
    for (const std::size_t vertex : {5, 90}) execute(*scene, {comb_at(*scene, vertex)});
    return scene;
  }
  void expect_frame(const char* what, const std::function<void(FrameRequest&)>& ask) {
    expect_ends(what, [&] {
      FrameRequest request;
      request.width = request.height = 64, request.knobs = knobs_of(Tier::draft);
      ask(request);
      const Result<FrameAnswer> answer = pictures_->frame(seen_, request);
      EXPECT_TRUE(answer.ok()) << what << ": " << answer.status().message;
    });
  }
  void expect_all_frames() {
    expect_frame("a frame", [](FrameRequest&) {});
    expect_frame("a frame of an earlier revision", [](FrameRequest& request) { request.revision = 1; });
    expect_frame("a comparison", [](FrameRequest& request) { request.overlay = Overlay::difference; });
    expect_frame("a traced frame", [](FrameRequest& request) {
      request.knobs = knobs_of(Tier::reference), request.knobs.trace.passes = 1;
    });
    expect_frame("a frame in a budget", [](FrameRequest& request) { request.budget_ms = 50; });
  }

  FailingDisk disk_;  // constructed before SetUp opens the store
  YieldGate gate_;
  std::unique_ptr<FrameService> frames_;
  std::unique_ptr<TraceQueue> traces_;
  std::unique_ptr<PictureService> pictures_;
  std::shared_ptr<Scene> commanded_, exported_, written_, seen_;
};

TEST_F(Locks, OfOtherScenesHoldUpNoFrame) {
  Held command([&](const std::function<void()>& middle) {
    EXPECT_TRUE(commanded_->execute({comb_at(*commanded_, 50)}, {.cancel = that_waits(middle)}).ok());
  });
  Held exported([&](const std::function<void()>& middle) {
    EXPECT_TRUE(export_scene(*exported_->snapshot(), {}, that_waits(middle)).ok());
  });
  Held saved([&](const std::function<void()>& middle) {
    EXPECT_TRUE(store_->save(*exported_, (folder_ / "saved").string(), that_waits(middle, 0)).ok());
  });
  std::once_flag first;
  Held written([&](const std::function<void()>& middle) {
    FailingDisk::during_sync = [&] { std::call_once(first, middle); };
    EXPECT_TRUE(written_->execute({comb_at(*written_, 50)}).ok());
  });
  std::future<bool> created = std::async(std::launch::async, [&] { return make() != nullptr; });
  expect_all_frames();
  expect_ends("a search", [&] { EXPECT_TRUE(store_->find(seen_->id()).ok()); });
  expect_ends("a list", [&] { EXPECT_EQ(store_->list().size(), 4u); });
  expect_ends("the look at what a key did", [&] { EXPECT_TRUE(store_->change_of_request({"/path", "key", ""}).ok()); });
  EXPECT_EQ(created.wait_for(std::chrono::seconds(0)), std::future_status::timeout) << "the disk has it already";
  written.end();
  EXPECT_TRUE(created.get());
  FailingDisk::during_sync = nullptr;
}

}  // namespace
}  // namespace pelage::testing::locks_test
