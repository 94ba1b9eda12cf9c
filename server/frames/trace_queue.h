// Pictures that are traced: a pass at a time, on a thread of its own.
#pragma once

#include <atomic>
#include <chrono>
#include <condition_variable>
#include <functional>
#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <thread>
#include <vector>

#include "base/status.h"
#include "protocol/commands/frame.h"
#include "server/frames/picture_tracer.h"
#include "server/frames/yield_gate.h"
#include "server/scene/scene.h"

namespace pelage {

/// The picture that a viewer has.
struct SeenPicture {
  Revision revision = 0;
  int passes = 0;  // 0 for shells

  bool operator==(const SeenPicture&) const = default;
};

/// Since the start.
struct TraceCounts {
  std::size_t traces = 0, passes = 0;
  double seconds = 0;
};

/// Traces pictures in turns. Thread-safe. The picture with the fewest passes is traced next; of those with equally
/// many, the one that was requested last. So a picture yields after one pass while another has none; otherwise, while
/// another has fewer, it yields after as many passes as it had, at most 64. If there is no room to set it aside, it
/// continues. A job is either a picture that its caller waits for, or a progressive picture: a picture of one revision
/// that gets better while somebody asks for it, and is dropped as soon as the scene leaves that revision. Jobs of a
/// named view yield to the view's next request.
class TraceQueue {
 public:
  using Clock = std::chrono::steady_clock;
  struct Limits {
    std::size_t waiting = 16;          // jobs before the tracer
    std::size_t max_progressive = 32;  // progressive pictures, ended ones too
    std::chrono::milliseconds settle_time{
        100};  // from a progressive picture's start to its tracing: the hand may go on
    std::chrono::milliseconds idle_timeout{30'000};      // that a progressive picture lives without being asked for,
    std::chrono::milliseconds busy_idle_timeout{2'000};  // and that it is traced so while other jobs wait
    std::chrono::milliseconds between{500};              // pictures for somebody who waits
    std::size_t aside_bytes = std::size_t{1} << 30;      // of all pictures that gave way
  };

  TraceQueue(std::unique_ptr<PictureTracer> tracer, YieldGate& gate, Limits limits);
  TraceQueue(std::unique_ptr<PictureTracer> tracer, YieldGate& gate) : TraceQueue(std::move(tracer), gate, Limits()) {}
  ~TraceQueue();

  /// Traces to the end. `abandoned` is asked four times a second. Fails with conflict when the same view asks for
  /// something else, unavailable when it was abandoned, too many wait or the server stops, not_found when the scene is
  /// removed, and as PictureTracer does.
  Result<std::shared_ptr<const LinearPicture>> trace(const std::shared_ptr<Scene>& scene, const FrameRequest& request,
                                                     const std::function<bool()>& abandoned = {});

  /// Records that somebody looks at a revision of the scene by this request (its `progressive`), and starts the
  /// progressive picture if there is none. Unavailable if too many wait.
  Status improve(const std::shared_ptr<Scene>& scene, const FrameRequest& request, Revision revision);

  /// Returns the progressive picture's newest picture if it is of the revision and has more passes than were seen; else
  /// its failure if it failed; else nothing. Does not wait: when the answer changes, the scene is woken (Scene::wake).
  std::optional<Result<std::shared_ptr<const LinearPicture>>> better(const Scene& scene, const FrameRequest& request,
                                                                     SeenPicture seen);

  /// The view of the request asks for something else than strands: what is traced for it is dropped.
  void turn_from(const Scene& scene, const FrameRequest& request);

  /// Ends all jobs at once and takes no more.
  void stop();

  TraceCounts counts() const;

 private:
  struct Job;
  using JobPtr = std::shared_ptr<Job>;

  // On the tracing thread.
  void run();
  /// Waits for a job and traces it for its turn; false at the end.
  bool trace_next();
  JobPtr next();
  /// Begins a picture or goes on with it.
  Status start(const JobPtr& job, const std::function<bool()>& go_on);
  /// Traces the job for its turn. Returns how the picture ended, or nothing if the job gave way to another one.
  std::optional<Status> trace_job(const JobPtr& job);
  bool give_way(const JobPtr& job);
  bool offer(const JobPtr& job);
  void end(const JobPtr& job, std::optional<Status> status, double seconds);
  bool still_wanted(const Job& job) const;

  // All of these need the lock.
  Status admit(const JobPtr& job);
  std::size_t count_waiting() const;
  JobPtr find(const Scene& scene, const std::string& key) const;
  void drop(const JobPtr& job, Status why);
  void drop_view(const Scene& scene, const std::string& view, const JobPtr& but);
  void make_room();
  void forget_old(Clock::time_point now);
  JobPtr next_ready(Clock::time_point now) const;
  std::size_t aside_bytes() const;
  Clock::time_point next_event() const;

  const Limits limits_;
  const std::unique_ptr<PictureTracer> tracer_;
  YieldGate& gate_;
  mutable std::mutex mutex_;
  std::condition_variable changed_;  // for the tracing thread
  std::condition_variable ended_;    // for those in trace()
  std::vector<JobPtr> jobs_;         // waiting, running, and progressive pictures that ended
  TraceCounts counts_;
  std::atomic<bool> stopping_{false};
  std::thread thread_;
};

}  // namespace pelage
