// The order in which the trace queue traces pictures, their turns, and its limits.
#include <future>
#include <thread>

#include "tests/unit/scene/trace_queue_fixture.h"

namespace pelage::trace_queue_test {
namespace {

TEST_F(TraceQueueTest, WaitsUntilTheSceneSettles) {
  const auto scene = make();
  TraceQueue::Limits limits = quick();
  limits.settle_time = 300ms;
  queue(limits);
  for (Revision revision = 0; revision < 5; ++revision) {
    ASSERT_TRUE(queue_->improve(scene, progressive(2), revision).ok());
    std::this_thread::sleep_for(10ms);
    execute(*scene, {comb_at(*scene, 5 + 7 * revision)});
  }
  const Revision last = scene->revision();
  ASSERT_TRUE(queue_->improve(scene, progressive(2), last).ok());
  EXPECT_TRUE(wait_better(*scene, progressive(2), {last, 1}));
  EXPECT_EQ(stage_.begun, 1);
}

TEST_F(TraceQueueTest, TakesWhatWasAskedForLast) {
  const auto scene = make();
  stage_.allowed = 0;
  ASSERT_TRUE(queue().improve(scene, progressive(2, "first"), 0).ok());
  ASSERT_TRUE(soon([&] { return stage_.begun == 1; }));
  for (const char* view : {"second", "third", "fourth"})
    ASSERT_TRUE(queue_->improve(scene, progressive(2, view), 0).ok());
  ASSERT_TRUE(queue_->improve(scene, progressive(2, "second"), 0).ok());  // requested again, so it becomes the latest
  stage_.allowed = 1000;
  ASSERT_TRUE(soon([&] { return stage_.begun == 4; }));
  const std::lock_guard lock(stage_.mutex);
  EXPECT_EQ(stage_.views, (std::vector<std::string>{"first", "second", "fourth", "third"}));
}

TEST_F(TraceQueueTest, ALongTraceLetsOthersFirstPassThrough) {
  const auto scene = make();
  queue();
  std::future<Picture> endless =
      std::async(std::launch::async, [&] { return queue_->trace(scene, traced(1'000'000)); });
  ASSERT_TRUE(soon([&] { return stage_.passes > 3; }));
  for (int i = 1; i <= 3; ++i) {
    std::future<Picture> other = std::async(std::launch::async, [&] { return queue_->trace(scene, traced(4)); });
    const bool came = other.wait_for(30s) == std::future_status::ready;
    EXPECT_TRUE(came) << "it waits for all passes of the other";
    if (!came) queue_->stop();
    EXPECT_EQ(other.get().ok(), came);
    EXPECT_TRUE(soon([&] { return stage_.resumed >= i; })) << "the long one goes on";
  }
  EXPECT_EQ(queue_->counts().traces, 4u);
  queue_->stop();
  EXPECT_FALSE(endless.get().ok());
}

TEST_F(TraceQueueTest, PicturesThatAreTracedTogetherTakeTurns) {
  const auto scene = make();
  queue();
  stage_.allowed = 0;
  std::vector<std::future<Picture>> pictures;
  for (int i = 0; i < 3; ++i) {
    pictures.push_back(std::async(std::launch::async, [&] { return queue_->trace(scene, traced(256)); }));
    ASSERT_TRUE(soon([&] { return stage_.begun == 1; }));
  }
  std::this_thread::sleep_for(50ms);  // until all are waiting
  stage_.allowed = 1'000'000;
  for (auto& picture : pictures) {
    const Picture traced_picture = picture.get();
    ASSERT_TRUE(traced_picture.ok());
    EXPECT_EQ((*traced_picture)->report.passes, 256);
  }
  EXPECT_EQ(stage_.passes, 3 * 256);
  EXPECT_GE(stage_.resumed, 3 * 7) << "turns of 1, 1, 2, 4 ... 64 passes";
  EXPECT_LE(stage_.resumed, 3 * 16) << "strands may grow anew for each turn, so turns are not of one pass";
}

TEST_F(TraceQueueTest, APictureGoesOnWhereItCannotBeSetAside) {
  const auto scene = make();
  TraceQueue::Limits limits = quick();
  limits.suspended_bytes = 99;
  queue(limits);
  std::future<Picture> first = std::async(std::launch::async, [&] { return queue_->trace(scene, traced(300)); });
  ASSERT_TRUE(soon([&] { return stage_.passes > 0; }));
  EXPECT_TRUE(queue_->trace(scene, traced(2)).ok());
  EXPECT_TRUE(first.get().ok());
  EXPECT_EQ(stage_.resumed, 0);
}

TEST_F(TraceQueueTest, YieldsWhileAnyoneGoesFirst) {
  const auto scene = make();
  ASSERT_TRUE(queue().improve(scene, progressive(1'000'000), 0).ok());
  ASSERT_TRUE(soon([&] { return stage_.passes > 2; }));
  {
    const YieldGate::Priority turn = gate_.take_priority();
    std::this_thread::sleep_for(20ms);  // lets a pass in progress end
    const int passes = stage_.passes;
    std::this_thread::sleep_for(100ms);
    EXPECT_EQ(stage_.passes, passes);
  }
  const int passes = stage_.passes;
  EXPECT_TRUE(soon([&] { return stage_.passes > passes; }));
}

TEST_F(TraceQueueTest, ARevisionEndsWhatIsHeldAtTheGate) {
  const auto scene = make();
  ASSERT_TRUE(queue().improve(scene, progressive(1'000'000), 0).ok());
  ASSERT_TRUE(soon([&] { return stage_.passes > 2; }));
  const int passes = [&] {
    const YieldGate::Priority turn = gate_.take_priority();
    execute(*scene, {comb_at(*scene, 5)});
    return stage_.passes.load();
  }();
  std::this_thread::sleep_for(50ms);
  EXPECT_LE(stage_.passes, passes + 1);
}

TEST_F(TraceQueueTest, RefusesWhenTooManyWait) {
  const auto scene = make();
  TraceQueue::Limits limits = quick();
  limits.waiting = 2;
  stage_.allowed = 0;
  ASSERT_TRUE(queue(limits).improve(scene, progressive(2, "a"), 0).ok());
  ASSERT_TRUE(soon([&] { return stage_.begun == 1; }));
  EXPECT_TRUE(queue_->improve(scene, progressive(2, "b"), 0).ok());
  EXPECT_TRUE(queue_->improve(scene, progressive(2, "c"), 0).ok());
  EXPECT_EQ(queue_->improve(scene, progressive(2, "d"), 0).code, Code::unavailable);
  EXPECT_EQ(queue_->trace(scene, traced(2)).status().code, Code::unavailable);
  EXPECT_TRUE(queue_->improve(scene, progressive(3, "c"), 0).ok()) << "in the place of what its view asked for before";
}

TEST_F(TraceQueueTest, BoundsTheNumberOfProgressivePictures) {
  const auto scene = make();
  TraceQueue::Limits limits = quick();
  limits.max_progressive = 3;
  queue(limits);
  for (const char* view : {"a", "b", "c", "d"}) {
    ASSERT_TRUE(queue_->improve(scene, progressive(1, view), 0).ok());
    ASSERT_TRUE(wait_better(*scene, progressive(1, view), {}));
    ASSERT_TRUE(soon([&] { return queue_->counts().passes == stage_.passes.load() + 0u; }));
    std::this_thread::sleep_for(20ms);  // until the job has ended
  }
  EXPECT_FALSE(queue_->better_picture(*scene, progressive(1, "a"), {}));
  EXPECT_TRUE(queue_->better_picture(*scene, progressive(1, "b"), {}));
  EXPECT_TRUE(queue_->better_picture(*scene, progressive(1, "d"), {}));
}

}  // namespace
}  // namespace pelage::trace_queue_test
