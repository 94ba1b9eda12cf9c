#include "server/frames/trace_queue.h"

#include <atomic>
#include <future>
#include <thread>

#include "tests/unit/scene/store_fixture.h"

namespace pelage::trace_queue_test {
namespace {

using namespace std::chrono_literals;
using Picture = Result<std::shared_ptr<const LinearPicture>>;

/// Controls the fake tracer, and counts what it has done.
struct Stage {
  std::atomic<int> allowed{1'000'000};  // passes of all jobs before it blocks
  std::atomic<bool> refuses{false};
  std::atomic<int> begun{0}, resumed{0}, passes{0};
  std::mutex mutex;
  std::vector<std::string> views;  // in the order in which they were begun
};

/// A tracer whose passes take a millisecond and poll go_on every tenth of it.
class FakeTracer : public PictureTracer {
 public:
  explicit FakeTracer(Stage& stage) : stage_(stage) {}

  Result<Revision> begin(const std::shared_ptr<Scene>& scene, const FrameRequest& request, const GoOn&) override {
    ++stage_.begun;
    {
      const std::lock_guard lock(stage_.mutex);
      stage_.views.push_back(request.view);
    }
    if (stage_.refuses) return failure(Code::too_large, "too many strands", "/quality/trace/strands");
    max_ = request.knobs.trace.passes;
    report_ = {};
    return scene->revision();
  }
  Status add_pass(const GoOn& go_on) override {
    for (int i = 0; i < 10 || stage_.passes >= stage_.allowed; ++i) {
      if (!go_on()) return failure(Code::unavailable, "not to go on");
      std::this_thread::sleep_for(100us);
    }
    ++stage_.passes;
    if (++report_.passes >= max_) report_.end = TraceEnd::passes;
    return {};
  }
  std::unique_ptr<SuspendedPicture> suspend() override { return std::make_unique<FakeSuspendedPicture>(report_, max_); }
  std::size_t bytes() const override { return 100; }
  Status resume(std::unique_ptr<SuspendedPicture> suspended, const GoOn&) override {
    const auto& fake = static_cast<const FakeSuspendedPicture&>(*suspended);
    report_ = fake.report, max_ = fake.max;
    ++stage_.resumed;
    return {};
  }
  TraceReport report() const override { return report_; }
  LinearPicture picture() const override { return {.report = report_}; }

 private:
  struct FakeSuspendedPicture : SuspendedPicture {
    FakeSuspendedPicture(const TraceReport& so_far, int passes) : report(so_far), max(passes) {}
    TraceReport report;
    int max;
  };

  Stage& stage_;
  TraceReport report_;
  int max_ = 0;
};

class TraceQueueTest : public StoreTest {
 protected:
  TraceQueue& queue(TraceQueue::Limits limits = quick()) {
    queue_ = std::make_unique<TraceQueue>(std::make_unique<FakeTracer>(stage_), gate_, limits);
    return *queue_;
  }
  static TraceQueue::Limits quick() {
    TraceQueue::Limits limits;
    limits.settle_time = 0ms, limits.min_interval = 0ms;
    return limits;
  }
  void TearDown() override {
    queue_.reset();  // before the store, since it holds the store's scenes
    StoreTest::TearDown();
  }

  static FrameRequest progressive(int passes, const std::string& view = "artist") {
    FrameRequest request;
    request.view = view;
    request.progressive = Tracing{.passes = passes};
    return request;
  }
  static FrameRequest traced(int passes, const std::string& view = "") {
    FrameRequest request;
    request.view = view;
    request.knobs = knobs_of(Tier::reference);
    request.knobs.trace.passes = passes;
    return request;
  }
  /// Returns a better picture, or none after some seconds, like a request that waits.
  std::optional<Picture> wait_better(const Scene& scene, const FrameRequest& request, SeenPicture seen,
                                     double seconds = 20) {
    scene.wait_newer(seen.revision, seconds, [&] { return queue_->better_picture(scene, request, seen).has_value(); });
    return scene.is_at(seen.revision) ? queue_->better_picture(scene, request, seen) : std::nullopt;
  }
  static bool soon(const std::function<bool()>& holds) {
    for (int i = 0; i < 4000 && !holds(); ++i) std::this_thread::sleep_for(5ms);
    return holds();
  }

  YieldGate gate_;
  Stage stage_;
  std::unique_ptr<TraceQueue> queue_;
};

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
