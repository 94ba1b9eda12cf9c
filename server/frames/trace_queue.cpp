#include "server/frames/trace_queue.h"

#include <algorithm>
#include <utility>

#include "base/caught.h"
#include "base/stopwatch.h"
#include "protocol/json/encode.h"

namespace pelage {

namespace {

constexpr std::chrono::milliseconds abandoned_slice{250};  // interval at which abandoned traces are detected
constexpr int max_turn_passes = 64;                        // maximum passes of a turn while another picture has fewer

enum class Stage { waiting, running, ended };

/// Returns whether a picture of so many passes (1, 2, 4, 6, 8, 12, 16, 24, ...) is offered even if no client waits for
/// it.
bool on_schedule(int passes) {
  int power = 1;
  while (power <= passes / 2) power *= 2;
  return passes == power || (passes >= 6 && passes == power + power / 2);
}

Status superseded() { return failure(Code::conflict, "superseded by a newer frame of the same view"); }
Status nobody_waits(const Scene& scene) {
  if (scene.removed()) return failure(Code::not_found, "the scene has been removed");
  return failure(Code::unavailable, "nobody waits for this picture any more");
}

}  // namespace

struct TraceQueue::Job {
  const std::shared_ptr<Scene> scene;
  const FrameRequest request;              // traced_request
  const std::string key;                   // JSON of the original request
  const std::optional<Revision> revision;  // set for a progressive picture
  const Clock::time_point start = Clock::now();
  Clock::time_point last_request = start, published = start;
  double queue_ms = 0;
  bool wanted = false;  // a client has asked for a better picture since the last one was offered
  Stage stage = Stage::waiting;
  Status status = {};  // why it ended; ok if its passes are complete
  std::shared_ptr<const LinearPicture> picture = {};
  std::atomic<bool> dropped{false};
  int passes = 0, passes_at_turn = 0;  // passes done; passes at the beginning of its turn
  std::unique_ptr<PictureTracer::SuspendedPicture> suspended = nullptr;  // the picture while it is set aside
  std::size_t suspended_bytes = 0;

  Job(std::shared_ptr<Scene> in, const FrameRequest& asked_for, std::optional<Revision> at)
      : scene(std::move(in)), request(traced_request(asked_for)), key(encode(asked_for)), revision(at) {}
};

TraceQueue::TraceQueue(std::unique_ptr<PictureTracer> tracer, YieldGate& gate, Limits limits)
    : limits_(limits), tracer_(std::move(tracer)), gate_(gate), thread_([this] { run(); }) {}

TraceQueue::~TraceQueue() {
  stop();
  thread_.join();
}

void TraceQueue::stop() {
  const std::lock_guard lock(mutex_);
  stopping_ = true;
  while (!jobs_.empty()) drop(jobs_.back(), server_stopping());
  gate_.wake();
  changed_.notify_all();
}

// Functions for callers.

Result<std::shared_ptr<const LinearPicture>> TraceQueue::trace(const std::shared_ptr<Scene>& scene,
                                                               const FrameRequest& request,
                                                               const std::function<bool()>& abandoned) {
  const auto job = std::make_shared<Job>(scene, request, std::nullopt);
  std::unique_lock lock(mutex_);
  if (Status refused = admit(job); !refused.ok()) return refused;
  while (!ended_.wait_for(lock, abandoned_slice, [&] { return job->stage == Stage::ended; })) {
    lock.unlock();
    const bool gone = scene->removed() || (abandoned && abandoned());
    lock.lock();
    if (gone) drop(job, nobody_waits(*scene));
  }
  if (!job->status.ok()) return job->status;
  return job->picture;
}

Status TraceQueue::improve(const std::shared_ptr<Scene>& scene, const FrameRequest& request, Revision revision) {
  if (!scene->is_at(revision)) return {};  // the client learns of the new revision when it asks again
  const auto job = std::make_shared<Job>(scene, request, revision);
  const std::lock_guard lock(mutex_);
  const JobPtr known = find(*scene, job->key);
  if (known && known->revision == revision) {
    known->last_request = job->last_request;
    return {};
  }
  if (known) drop(known, superseded());
  return admit(job);
}

std::optional<Result<std::shared_ptr<const LinearPicture>>> TraceQueue::better_picture(const Scene& scene,
                                                                                       const FrameRequest& request,
                                                                                       SeenPicture seen) {
  const std::string key = encode(request);
  const std::lock_guard lock(mutex_);
  const JobPtr job = find(scene, key);
  if (!job || job->revision != seen.revision) return {};
  job->last_request = Clock::now();
  if (job->picture && job->picture->report.passes > seen.passes) return Result(job->picture);
  if (!job->status.ok()) return Result<std::shared_ptr<const LinearPicture>>(job->status);
  job->wanted = true;
  return {};
}

void TraceQueue::supersede_view(const Scene& scene, const FrameRequest& request) {
  const std::lock_guard lock(mutex_);
  drop_view(scene, request.view, nullptr);
}

TraceCounts TraceQueue::counts() const {
  const std::lock_guard lock(mutex_);
  return counts_;
}

// The list of jobs. The caller of these must hold the lock.

Status TraceQueue::admit(const JobPtr& job) {
  if (stopping_) return server_stopping();
  drop_view(*job->scene, job->request.view, job);
  forget_old(job->start);
  if (count_waiting() >= limits_.waiting) {
    return failure(Code::unavailable, "Too many pictures wait to be traced.", "",
                   "at most " + std::to_string(limits_.waiting));
  }
  drop_oldest_ended();
  jobs_.push_back(job);
  changed_.notify_all();
  return {};
}

std::size_t TraceQueue::count_waiting() const {
  const auto waits = [](const JobPtr& job) { return job->stage == Stage::waiting; };
  return static_cast<std::size_t>(std::count_if(jobs_.begin(), jobs_.end(), waits));
}

/// Returns the progressive job of that scene and request, or null.
TraceQueue::JobPtr TraceQueue::find(const Scene& scene, const std::string& key) const {
  const auto found = std::find_if(jobs_.begin(), jobs_.end(), [&](const JobPtr& job) {
    return job->revision && job->scene.get() == &scene && job->key == key;
  });
  return found == jobs_.end() ? nullptr : *found;
}

void TraceQueue::drop(const JobPtr& job, Status why) {
  // NOLINTNEXTLINE(performance-unnecessary-copy-initialization): the argument may lie in the list
  const JobPtr dropped_job = job;
  std::erase(jobs_, dropped_job);
  dropped_job->dropped = true;
  if (dropped_job->stage == Stage::running) gate_.wake();
  if (dropped_job->stage != Stage::ended) dropped_job->status = std::move(why);
  dropped_job->stage = Stage::ended;
  ended_.notify_all();
}

void TraceQueue::drop_view(const Scene& scene, const std::string& view, const JobPtr& but) {
  if (view.empty()) return;
  const std::vector<JobPtr> jobs = jobs_;
  for (const JobPtr& job : jobs) {
    if (job != but && job->scene.get() == &scene && job->request.view == view) drop(job, superseded());
  }
}

/// Drops the ended progressive picture that was requested least recently, if the list is full.
void TraceQueue::drop_oldest_ended() {
  if (jobs_.size() < limits_.max_progressive) return;
  const auto oldest = std::min_element(jobs_.begin(), jobs_.end(), [](const JobPtr& a, const JobPtr& b) {
    return std::pair(a->stage != Stage::ended, a->last_request) < std::pair(b->stage != Stage::ended, b->last_request);
  });
  if ((*oldest)->stage == Stage::ended) drop(*oldest, nobody_waits(*(*oldest)->scene));
}

void TraceQueue::forget_old(Clock::time_point now) {
  const std::vector<JobPtr> jobs = jobs_;
  const bool others_wait = count_waiting() > 0;
  for (const JobPtr& job : jobs) {
    const auto idle_timeout =
        others_wait && job->stage == Stage::running ? limits_.busy_idle_timeout : limits_.idle_timeout;
    const bool old = job->revision && now - job->last_request > idle_timeout;
    if (old || !still_wanted(*job)) drop(job, nobody_waits(*job->scene));
  }
}

TraceQueue::JobPtr TraceQueue::next_ready(Clock::time_point now) const {
  JobPtr first;
  const auto rank = [](const JobPtr& job) { return std::pair(-job->passes, job->last_request); };
  for (const JobPtr& job : jobs_) {
    const bool ready = job->stage == Stage::waiting && (!job->revision || now - job->start >= limits_.settle_time);
    if (ready && (!first || rank(job) > rank(first))) first = job;
  }
  return first;
}

std::size_t TraceQueue::suspended_bytes() const {
  std::size_t bytes = 0;
  for (const JobPtr& job : jobs_) bytes += job->suspended ? job->suspended_bytes : 0;
  return bytes;
}

/// Returns the time at which the next job becomes ready or expires.
TraceQueue::Clock::time_point TraceQueue::next_event() const {
  Clock::time_point first = Clock::now() + limits_.idle_timeout;
  for (const JobPtr& job : jobs_) {
    first = std::min(first, job->stage == Stage::waiting ? job->start + limits_.settle_time
                                                         : job->last_request + limits_.idle_timeout);
  }
  return first;
}

// The tracing thread.

void TraceQueue::run() {
  for (Result<bool> go_on = true; !go_on || *go_on;) go_on = caught([&] { return Result<bool>(trace_next()); });
}

bool TraceQueue::trace_next() {
  const JobPtr job = next();
  if (!job) return false;
  const Stopwatch passed;
  std::optional<Status> status;
  const Status thrown = caught([&] { return status = trace_job(job), Status{}; });
  if (!thrown.ok()) status = thrown;
  end(job, std::move(status), passed.seconds());
  return true;
}

TraceQueue::JobPtr TraceQueue::next() {
  std::unique_lock lock(mutex_);
  for (;;) {
    if (stopping_) return nullptr;
    const Clock::time_point now = Clock::now();
    forget_old(now);
    if (JobPtr job = next_ready(now)) {
      job->stage = Stage::running, job->passes_at_turn = job->passes;
      if (job->passes > 0) return job;
      ++counts_.traces;
      job->queue_ms = std::chrono::duration<double, std::milli>(now - job->start).count();
      return job;
    }
    changed_.wait_until(lock, next_event());
  }
}

/// Takes no lock, because tracing threads call it often.
bool TraceQueue::still_wanted(const Job& job) const {
  if (stopping_ || job.dropped || job.scene->removed()) return false;
  return !job.revision || job.scene->is_at(*job.revision);
}

Status TraceQueue::start(const JobPtr& job, const GoOn& go_on) {
  if (!go_on()) return nobody_waits(*job->scene);
  if (job->suspended) return tracer_->resume(std::move(job->suspended), go_on);
  const Result<Revision> begun = tracer_->begin(job->scene, job->request, go_on);
  if (!begun) return begun.status();
  if (job->revision && *begun != *job->revision) return nobody_waits(*job->scene);  // the scene changed meanwhile
  return {};
}

std::optional<Status> TraceQueue::trace_job(const JobPtr& job) {
  const GoOn go_on = [&] { return gate_.pass([&] { return still_wanted(*job); }); };
  if (Status started = start(job, go_on); !started.ok()) return started;
  for (;;) {
    if (Status added = tracer_->add_pass(go_on); !added.ok()) return added;
    if (publish_if_due(job)) return Status{};
    if (try_yield(job)) return {};
  }
}

/// Called after a pass that was not the last one. Returns whether the job yields to another one.
bool TraceQueue::try_yield(const JobPtr& job) {
  const std::lock_guard lock(mutex_);
  const JobPtr other = next_ready(Clock::now());
  if (!other || other->passes >= job->passes || job->stage == Stage::ended) return false;
  const int turn_passes = std::clamp(job->passes_at_turn, 1, max_turn_passes);
  if (other->passes > 0 && job->passes - job->passes_at_turn < turn_passes) return false;
  job->suspended_bytes = tracer_->bytes();
  if (suspended_bytes() + job->suspended_bytes > limits_.suspended_bytes) return false;
  job->suspended = tracer_->suspend();
  job->stage = Stage::waiting;
  return true;
}

/// Called after a pass: offers the picture if it is due. Returns whether that was the last pass.
bool TraceQueue::publish_if_due(const JobPtr& job) {
  const TraceReport report = tracer_->report();
  const bool last = report.end != TraceEnd::none;
  const Clock::time_point now = Clock::now();
  {
    const std::lock_guard lock(mutex_);
    ++counts_.passes, ++job->passes;
    forget_old(now);
    const bool waited_for = job->wanted && now - job->published >= limits_.min_interval;
    if (!last && !(job->revision && (waited_for || on_schedule(report.passes)))) return false;
  }
  auto picture = std::make_shared<LinearPicture>(tracer_->picture());
  picture->timings.queue = job->queue_ms;
  {
    const std::lock_guard lock(mutex_);
    job->picture = std::move(picture);
    job->published = now, job->wanted = false;
  }
  if (job->revision) job->scene->wake();
  return last;
}

/// Ends a job's turn. Without a status, the job yielded to another one. A dropped job is already out of the list. A
/// progressive picture stays in the list, for callers that ask for its picture or its error.
void TraceQueue::end(const JobPtr& job, std::optional<Status> status, double seconds) {
  {
    const std::lock_guard lock(mutex_);
    counts_.seconds += seconds;
    if (!status) return;
    if (!status->ok() && job->scene->removed()) status = nobody_waits(*job->scene);
    if (job->stage != Stage::ended) job->status = *std::move(status);
    job->stage = Stage::ended;
    if (!job->revision || !still_wanted(*job)) std::erase(jobs_, job);
    ended_.notify_all();
  }
  if (job->revision) job->scene->wake();
}

}  // namespace pelage
