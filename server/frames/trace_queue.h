// The queue of traced pictures: a thread that traces them, one pass at a time.
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

/// The picture that a client already has.
struct SeenPicture {
  Revision revision = 0;
  int passes = 0;  // 0 for the first, untraced picture

  bool operator==(const SeenPicture&) const = default;
};

/// Counts since the start.
struct TraceCounts {
  std::size_t traces = 0, passes = 0;
  double seconds = 0;
};

/// Traces pictures in turns. Thread-safe. The picture with the fewest passes is traced next; of equal ones, the one
/// that was requested last. A picture yields after one pass while another has none. While another has fewer passes, it
/// yields after as many passes as it had at the beginning of its turn, at most 64. If there is no room to set it aside,
/// it continues. A job is either a picture that its caller waits for, or a progressive picture: a picture of one
/// revision that improves while a client asks for it, and is dropped as soon as the scene leaves that revision. Jobs of
/// a named view are superseded by the view's next request.
class TraceQueue {
 public:
  using Clock = std::chrono::steady_clock;
  struct Limits {
    std::size_t waiting = 16;          // maximum number of waiting jobs
    std::size_t max_progressive = 32;  // from this many jobs on, a new one drops the ended one requested least recently
    std::chrono::milliseconds settle_time{
        100};  // from a progressive picture's start to its tracing, since the user may still be moving
    std::chrono::milliseconds idle_timeout{30'000};      // lifetime of a progressive picture without requests
    std::chrono::milliseconds busy_idle_timeout{2'000};  // the same while it is traced and other jobs wait
    std::chrono::milliseconds min_interval{500};         // minimum interval of pictures for a waiting client
    std::size_t suspended_bytes = std::size_t{1} << 30;  // memory limit of pictures that are set aside
  };

  TraceQueue(std::unique_ptr<PictureTracer> tracer, YieldGate& gate, Limits limits);
  TraceQueue(std::unique_ptr<PictureTracer> tracer, YieldGate& gate) : TraceQueue(std::move(tracer), gate, Limits()) {}
  ~TraceQueue();

  /// Traces a picture to the end. `abandoned` is polled four times a second. Fails with conflict if the same view
  /// requests something else; with unavailable if it was abandoned, too many jobs wait or the server stops; with
  /// not_found if the scene is removed; and as PictureTracer does.
  Result<std::shared_ptr<const LinearPicture>> trace(const std::shared_ptr<Scene>& scene, const FrameRequest& request,
                                                     const std::function<bool()>& abandoned = {});

  /// Records that a client views a revision of the scene with this request's `progressive`, and starts the progressive
  /// picture if there is none. Fails with unavailable if too many wait.
  Status improve(const std::shared_ptr<Scene>& scene, const FrameRequest& request, Revision revision);

  /// Returns the newest picture of the progressive job if it has more passes than were seen, its error if it failed,
  /// else nothing; also nothing if the job is of another revision than was seen. Does not wait; when the answer
  /// changes, waiters of the scene are woken (Scene::wake).
  std::optional<Result<std::shared_ptr<const LinearPicture>>> better_picture(const Scene& scene,
                                                                             const FrameRequest& request,
                                                                             SeenPicture seen);

  /// Drops the jobs of the request's view, which now requests something other than traced strands.
  void supersede_view(const Scene& scene, const FrameRequest& request);

  /// Ends all jobs at once and accepts no more.
  void stop();

  TraceCounts counts() const;

 private:
  struct Job;
  using JobPtr = std::shared_ptr<Job>;

  // Called on the tracing thread.
  void run();
  /// Waits for a job and traces it for one turn. Returns false at the end.
  bool trace_next();
  JobPtr next();
  /// Begins or resumes a picture.
  Status start(const JobPtr& job, const std::function<bool()>& go_on);
  /// Traces the job for one turn. Returns how the picture ended, or nothing if the job yielded to another one.
  std::optional<Status> trace_job(const JobPtr& job);
  bool try_yield(const JobPtr& job);
  bool publish_if_due(const JobPtr& job);
  void end(const JobPtr& job, std::optional<Status> status, double seconds);
  bool still_wanted(const Job& job) const;

  // The caller of these must hold the lock.
  Status admit(const JobPtr& job);
  std::size_t count_waiting() const;
  JobPtr find(const Scene& scene, const std::string& key) const;
  void drop(const JobPtr& job, Status why);
  void drop_view(const Scene& scene, const std::string& view, const JobPtr& but);
  void drop_oldest_ended();
  void forget_old(Clock::time_point now);
  JobPtr next_ready(Clock::time_point now) const;
  std::size_t suspended_bytes() const;
  Clock::time_point next_event() const;

  const Limits limits_;
  const std::unique_ptr<PictureTracer> tracer_;
  YieldGate& gate_;
  mutable std::mutex mutex_;
  std::condition_variable changed_;  // wakes the tracing thread
  std::condition_variable ended_;    // wakes callers of trace()
  std::vector<JobPtr> jobs_;         // waiting and running jobs, and ended progressive pictures
  TraceCounts counts_;
  std::atomic<bool> stopping_{false};
  std::thread thread_;
};

}  // namespace pelage
