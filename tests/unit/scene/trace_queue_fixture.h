// A fixture with a trace queue over a fake tracer, which a test controls.
#pragma once

#include <atomic>
#include <chrono>
#include <functional>
#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <thread>
#include <vector>

#include "server/frames/trace_queue.h"
#include "tests/unit/scene/store_fixture.h"

namespace pelage::trace_queue_test {

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

}  // namespace pelage::trace_queue_test
