// Pictures of the trace queue: what it answers, and what ends or drops them.
#include <future>
#include <thread>

#include "tests/unit/scene/trace_queue_fixture.h"

namespace pelage::trace_queue_test {
namespace {

TEST_F(TraceQueueTest, TracesToTheEnd) {
  const auto scene = make();
  const Picture picture = queue().trace(scene, traced(5));
  ASSERT_TRUE(picture.ok()) << picture.status().message;
  EXPECT_EQ((*picture)->report.passes, 5);
  EXPECT_EQ((*picture)->report.end, TraceEnd::passes);
  EXPECT_EQ(queue_->counts().traces, 1u);
  EXPECT_EQ(queue_->counts().passes, 5u);
}

TEST_F(TraceQueueTest, PassesOfAProgressivePictureRise) {
  const auto scene = make();
  const FrameRequest request = progressive(40);
  ASSERT_TRUE(queue().improve(scene, request, 0).ok());
  SeenPicture seen;
  while (seen.passes < 40) {
    const auto better_picture = wait_better(*scene, request, seen);
    ASSERT_TRUE(better_picture && better_picture->ok());
    ASSERT_GT((**better_picture)->report.passes, seen.passes);
    seen.passes = (**better_picture)->report.passes;
  }
  EXPECT_EQ(stage_.begun, 1);
  EXPECT_FALSE(wait_better(*scene, request, seen, 0.1)) << "nothing is better than the last";
  EXPECT_TRUE(queue_->better_picture(*scene, request, {0, 39})) << "the last stays";
}

TEST_F(TraceQueueTest, AnswersOnlyForTheSameRequestAndRevision) {
  const auto scene = make(), other = make();
  const FrameRequest request = progressive(2);
  ASSERT_TRUE(queue().improve(scene, request, 0).ok());
  ASSERT_TRUE(wait_better(*scene, request, {0, 1}));
  FrameRequest wider = request;
  wider.width *= 2;
  EXPECT_FALSE(queue_->better_picture(*scene, wider, {}));
  EXPECT_FALSE(queue_->better_picture(*scene, request, {1, 0}));
  EXPECT_FALSE(queue_->better_picture(*other, request, {}));
  ASSERT_TRUE(queue_->improve(scene, request, 0).ok());
  EXPECT_TRUE(queue_->better_picture(*scene, request, {})) << "asking again begins nothing anew";
  EXPECT_EQ(stage_.begun, 1);
}

TEST_F(TraceQueueTest, ANewRevisionEndsAProgressivePicture) {
  const auto scene = make();
  const FrameRequest request = progressive(1'000'000);
  ASSERT_TRUE(queue().improve(scene, request, 0).ok());
  ASSERT_TRUE(wait_better(*scene, request, {}));
  execute(*scene, {comb_at(*scene, 5)});
  ASSERT_TRUE(soon([&] { return !queue_->better_picture(*scene, request, {}); }));
  const int passes = stage_.passes;
  ASSERT_TRUE(queue_->improve(scene, request, 0).ok());  // an outdated revision, so it is ignored
  std::this_thread::sleep_for(50ms);
  EXPECT_LE(stage_.passes, passes + 1);
  EXPECT_EQ(stage_.begun, 1);
  ASSERT_TRUE(queue_->improve(scene, request, 1).ok());
  EXPECT_TRUE(wait_better(*scene, request, {1, 0}));
  move(*scene, Undo{});
  EXPECT_TRUE(soon([&] { return !queue_->better_picture(*scene, request, {1, 0}); }));
}

TEST_F(TraceQueueTest, AnEndedProgressivePictureIsForgottenWithItsRevision) {
  const auto scene = make();
  const FrameRequest request = progressive(2), other = progressive(2, "other");
  ASSERT_TRUE(queue().improve(scene, request, 0).ok());
  ASSERT_TRUE(wait_better(*scene, request, {0, 1}));
  execute(*scene, {comb_at(*scene, 5)});
  ASSERT_TRUE(queue_->improve(scene, other, 1).ok());
  EXPECT_FALSE(queue_->better_picture(*scene, request, {}));
}

TEST_F(TraceQueueTest, AViewThatAsksForSomethingElseDropsWhatItAskedFor) {
  const auto scene = make();
  const FrameRequest request = progressive(1'000'000), bystander = progressive(2, "other");
  ASSERT_TRUE(queue().improve(scene, request, 0).ok());
  ASSERT_TRUE(queue_->improve(scene, bystander, 0).ok());
  ASSERT_TRUE(wait_better(*scene, request, {}));
  FrameRequest turned = request;
  turned.camera.automatic = AutoView::back;
  ASSERT_TRUE(queue_->improve(scene, turned, 0).ok());
  EXPECT_FALSE(queue_->better_picture(*scene, request, {}));
  EXPECT_TRUE(wait_better(*scene, turned, {}));
  queue_->supersede_view(*scene, turned);
  EXPECT_FALSE(queue_->better_picture(*scene, turned, {}));
  EXPECT_TRUE(wait_better(*scene, bystander, {0, 1})) << "other views go on";
}

TEST_F(TraceQueueTest, ANewerTraceOfTheViewSupersedes) {
  const auto scene = make();
  queue();
  std::future<Picture> first =
      std::async(std::launch::async, [&] { return queue_->trace(scene, traced(1'000'000, "artist")); });
  ASSERT_TRUE(soon([&] { return stage_.passes > 0; }));
  EXPECT_TRUE(queue_->trace(scene, traced(3, "artist")).ok());
  EXPECT_EQ(first.get().status().code, Code::conflict);
}

TEST_F(TraceQueueTest, ATraceThatNobodyWaitsForIsDropped) {
  const auto scene = make();
  EXPECT_EQ(queue().trace(scene, traced(1'000'000), [] { return true; }).status().code, Code::unavailable);
  const int passes = stage_.passes;
  std::this_thread::sleep_for(50ms);
  EXPECT_LE(stage_.passes, passes + 1);
}

TEST_F(TraceQueueTest, ATraceOutlivesARevision) {
  const auto scene = make();
  queue();
  stage_.allowed = 1;
  std::future<Picture> picture = std::async(std::launch::async, [&] { return queue_->trace(scene, traced(5)); });
  ASSERT_TRUE(soon([&] { return stage_.passes > 0; }));
  execute(*scene, {comb_at(*scene, 5)});
  stage_.allowed = 1000;
  EXPECT_TRUE(picture.get().ok());
}

TEST_F(TraceQueueTest, ARemovedSceneEndsItsJobs) {
  const auto scene = make();
  const FrameRequest request = progressive(1'000'000);
  queue();
  std::future<Picture> picture =
      std::async(std::launch::async, [&] { return queue_->trace(scene, traced(1'000'000)); });
  ASSERT_TRUE(soon([&] { return stage_.passes > 0; }));
  ASSERT_TRUE(store_->remove(scene->id()).ok());
  EXPECT_EQ(picture.get().status().code, Code::not_found);
  EXPECT_TRUE(queue_->trace(make(), traced(2)).ok()) << "the tracer is free again";
}

TEST_F(TraceQueueTest, AProgressivePictureThatNobodyAsksForIsDropped) {
  const auto scene = make();
  const FrameRequest request = progressive(1'000'000);
  TraceQueue::Limits limits = quick();
  limits.idle_timeout = 200ms;
  ASSERT_TRUE(queue(limits).improve(scene, request, 0).ok());
  ASSERT_TRUE(soon([&] { return stage_.passes > 0; }));
  for (int i = 0; i < 10; ++i) {  // polls for longer than idle_timeout
    std::this_thread::sleep_for(50ms);
    ASSERT_TRUE(queue_->improve(scene, request, 0).ok());
  }
  EXPECT_EQ(stage_.begun, 1);
  std::this_thread::sleep_for(600ms);
  const int passes = stage_.passes;
  std::this_thread::sleep_for(50ms);
  EXPECT_EQ(stage_.passes, passes);
  EXPECT_FALSE(queue_->better_picture(*scene, request, {}));
}

TEST_F(TraceQueueTest, AProgressivePictureThatNobodyAsksForGivesWay) {
  const auto scene = make();
  TraceQueue::Limits limits = quick();
  limits.busy_idle_timeout = 200ms;
  const FrameRequest left = progressive(1'000'000, "left"), next = progressive(2, "next");
  ASSERT_TRUE(queue(limits).improve(scene, left, 0).ok());
  ASSERT_TRUE(soon([&] { return stage_.passes > 0; }));
  std::this_thread::sleep_for(400ms);
  EXPECT_TRUE(queue_->better_picture(*scene, left, {})) << "nobody else waits";
  ASSERT_TRUE(queue_->improve(scene, next, 0).ok());
  EXPECT_TRUE(wait_better(*scene, next, {0, 1})) << "both have their turns while somebody looks";
  const FrameRequest other = progressive(1'000'000, "other");  // keeps tracing
  ASSERT_TRUE(queue_->improve(scene, other, 0).ok());
  const auto gone_unasked = [&] {
    for (int i = 0; i < 12; ++i) {
      std::this_thread::sleep_for(50ms);
      EXPECT_TRUE(queue_->improve(scene, other, 0).ok());
    }
    return !queue_->better_picture(*scene, left, {});  // asks for it at the same time
  };
  bool gone = false;
  for (int i = 0; i < 20 && !gone; ++i) gone = gone_unasked();
  EXPECT_TRUE(gone);
}

TEST_F(TraceQueueTest, PassesAFailureOn) {
  const auto scene = make();
  stage_.refuses = true;
  const Picture refused = queue().trace(scene, traced(4));
  EXPECT_EQ(refused.status().code, Code::too_large);
  EXPECT_EQ(refused.status().pointer, "/quality/trace/strands");
  ASSERT_TRUE(queue_->improve(scene, progressive(4), 0).ok());
  const auto better_picture = wait_better(*scene, progressive(4), {});
  ASSERT_TRUE(better_picture);
  EXPECT_EQ(better_picture->status().code, Code::too_large);
}

TEST_F(TraceQueueTest, StopsAtOnce) {
  const auto scene = make();
  queue();
  std::future<Picture> running =
      std::async(std::launch::async, [&] { return queue_->trace(scene, traced(1'000'000)); });
  ASSERT_TRUE(soon([&] { return stage_.passes > 0; }));
  std::future<Picture> waiting = std::async(std::launch::async, [&] { return queue_->trace(scene, traced(2)); });
  const YieldGate::Priority turn = gate_.take_priority();  // stop() also ends work that is held at the gate
  queue_->stop();
  EXPECT_EQ(running.get().status().code, Code::unavailable);
  EXPECT_EQ(waiting.get().status().code, Code::unavailable);
  EXPECT_EQ(queue_->improve(scene, progressive(2), 0).code, Code::unavailable);
  queue_.reset();
}

TEST(TracedRequest, IsThatOfTheReferenceTier) {
  FrameRequest request;
  request.knobs.scale = 2, request.knobs.eye_steps = 5;
  request.progressive = Tracing{.passes = 7};
  const FrameRequest traced = traced_request(request);
  EXPECT_FALSE(traced.progressive);
  EXPECT_EQ(traced.knobs.method, Method::strands);
  EXPECT_EQ(traced.knobs.trace.passes, 7);
  EXPECT_EQ(traced.knobs.eye_steps, 5);
  EXPECT_EQ(traced.knobs.scale, 1);
}

}  // namespace
}  // namespace pelage::trace_queue_test
