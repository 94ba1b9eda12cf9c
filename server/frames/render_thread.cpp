#include "server/frames/render_thread.h"

#include <algorithm>
#include <optional>

#include "server/frames/frame_file.h"

namespace pelage {

namespace {

constexpr int max_restarts = 2;                       // maximum restarts of a frame whose scene changed meanwhile
constexpr std::size_t max_running = 4;                // nesting of frames drawn in pauses; each holds its picture
constexpr std::chrono::milliseconds look_again{250};  // interval of checks for clients that have left

Status left_alone() { return failure(Code::unavailable, "nobody waits for this frame any more"); }

/// Returns the number of coats to bake at a time. Each bakes on two threads, in addition to the render thread.
int baking_threads() { return std::max(1, default_threads() / 4); }

}  // namespace

FrameService::Impl::Impl(ContextSource source, YieldGate& yield_gate, std::size_t coat_memory, int asked_threads)
    : contexts(std::move(source)),
      gate(yield_gate),
      baker(baking_threads(), coat_memory, [this] { wake_up(); }),
      threads(drawing_threads(asked_threads)),
      png(threads) {}

void FrameService::Impl::run(std::promise<Status>& started) {
  Result<std::unique_ptr<Context>> opened = contexts();
  if (!opened) return started.set_value(opened.status());
  context = std::move(*opened);
  planner.set_calibration(default_calibration(threads));
  Result<std::unique_ptr<Renderer>> renderer =
      make_renderer(context.get(), threads, [this](const Coat& coat) { return baker.wait(coat); });
  if (!renderer) return started.set_value(renderer.status());
  description = drawn_by(context.get(), (*renderer)->strands_by_gl());
  draws_shells = context != nullptr;
  started.set_value({});
  serve(**renderer);
  renderer->reset(), context.reset();  // GL objects must be freed before their context
}

void FrameService::Impl::renew_gl(Renderer& renderer) {
  ++lost_contexts;
  static_cast<void>(renderer.take_gl(nullptr));
  context.reset();
  if (Result<std::unique_ptr<Context>> opened = contexts()) context = std::move(*opened);
  if (context && !renderer.take_gl(&context->gl()).ok()) context.reset();
  draws_shells = context != nullptr;
  const std::lock_guard lock(mutex);
  description = drawn_by(context.get(), renderer.strands_by_gl());
}

bool FrameService::Impl::has_work() const {
  const auto ready = [](const std::unique_ptr<FrameJob>& job) { return job->ready(); };
  return stopping || jobs.any(ready) || !tasks.empty() || !forgotten.empty() || past_scenes.has_released();
}

void FrameService::Impl::serve(Renderer& renderer) {
  // An exception outside a frame's drawing loses one job, whose client gets an error; the loop serves the others.
  for (Result<bool> go_on = true; !go_on || *go_on;) go_on = caught([&] { return Result<bool>(serve_next(renderer)); });
  while (auto job = jobs.take()) job->job->answer.set_value(server_stopping());
  for (const RenderTask& task : tasks) task(nullptr);
  tasks.clear();
}

bool FrameService::Impl::serve_next(Renderer& renderer) {
  const auto ready = [](const std::unique_ptr<FrameJob>& waiting) { return waiting->ready(); };
  std::optional<ShortestFirst<std::unique_ptr<FrameJob>>::Taken> job;
  RenderTask task;
  bool forgot = false;
  {
    std::unique_lock lock(mutex);
    while (!has_work()) jobs.empty() ? wake.wait(lock) : static_cast<void>(wake.wait_for(lock, look_again));
    forgot = forget_gone(renderer);
    if (stopping) return false;
    job = jobs.take(ready);
    if (!job && !tasks.empty()) {
      task = std::move(tasks.front());
      tasks.pop_front();
    }
  }
  if (forgot) trim_allocator();
  if (job) finish(renderer, std::move(*job));
  if (task) task(&renderer);
  return true;
}

bool FrameService::Impl::forget_gone(Renderer& renderer) {
  std::vector<std::uint64_t> gone = past_scenes.take_released();
  gone.insert(gone.end(), forgotten.begin(), forgotten.end());
  forgotten.clear();
  if (gone.empty()) return false;
  for (const std::uint64_t model : gone)
    renderer.forget(model), memory.forget(renderer, model), copy_states.forget(model);
  return true;
}

void FrameService::Impl::finish(Renderer& renderer, ShortestFirst<std::unique_ptr<FrameJob>>::Taken taken) {
  FrameJob& job = *taken.job;
  job.since_start = {};
  {
    const std::lock_guard lock(mutex);
    running.push_back(&job);
  }
  const auto drawn_or_status = [&] { return caught([&] { return draw(renderer, job); }); };
  Result<DrawnFrame> frame = drawn_or_status();
  for (; !frame && job.outdated; ++job.restarts) {
    job.outdated = job.given_up = false;
    frame = drawn_or_status();
  }
  for (; renderer.lost_gl(); ++job.lost_contexts) {  // its coat may need baking again, and it waits meanwhile
    renew_gl(renderer);
    if (job.lost_contexts == 0) frame = drawn_or_status();
  }
  {
    const std::lock_guard lock(mutex);
    running.pop_back();
    if (std::exchange(job.put_back, false)) return jobs.put_back(std::move(taken));
  }
  job.answer.set_value(std::move(frame));
}

bool FrameService::Impl::run_interleaved(Renderer& renderer, FrameJob& job) {
  const Stopwatch passed;
  const auto may = [&](const std::unique_ptr<FrameJob>& other) {
    return other->ready() && (job.restarts < max_restarts || other->snapshot()->view().copy_id != job.copy_id);
  };
  // Once it has taken longer than expected, the time taken counts as its cost, so that longer frames count as short.
  const double taken = job.since_start.milliseconds() - job.paused;
  auto next = [&, moment = std::optional<std::uint64_t>()]() mutable {
    const std::lock_guard lock(mutex);
    job.given_up = job.given_up || stopping;
    if (!moment) moment = jobs.moment();
    if (running.size() >= max_running) return std::optional<ShortestFirst<std::unique_ptr<FrameJob>>::Taken>();
    return jobs.take_interleaved(std::max(job.cost(), taken), *moment, may);
  };
  while (auto other = next()) finish(renderer, std::move(*other));
  job.overdue = taken > 1e3 * job.order.request.max_seconds;
  job.given_up = job.given_up || job.outdated || job.overdue || job.order.is_abandoned();
  const std::lock_guard lock(mutex);
  job.paused += passed.milliseconds();
  return !job.given_up;
}

void FrameService::Impl::mark_outdated(const FrameJob& job) {
  for (FrameJob* other : running)
    other->outdated = other->outdated || (other->copy_id == job.copy_id && !other->shows_same(job));
}

void FrameService::Impl::count(double milliseconds, const Status& outcome) {
  seconds = seconds + milliseconds / 1e3;
  if (outcome.code == Code::unavailable) healthy = false;
}

Status FrameService::Impl::can_draw(const Knobs& knobs) const {
  if (knobs.method != Method::shells || draws_shells) return {};
  return failure(Code::invalid, "This server has no GL, which draws shells.", "/quality/method", "raster or strands");
}

Result<DrawnFrame> FrameService::Impl::draw(Renderer& renderer, FrameJob& job) {
  if (job.order.is_abandoned()) return left_alone();
  const Stopwatch passed;
  ShownScene shown =
      sync_snapshot(renderer, copy_states, job.snapshot(), job.order.request, job.order.view.compared.get());
  job.copy_id = shown.copy_id(), job.revision = shown.revision(), job.moment = shown.moment;
  mark_outdated(job);
  shown.fur.knobs = job.order.plan.knobs;
  if (Status can = can_draw(shown.fur.knobs); !can.ok()) return can;  // the GL may have been lost meanwhile
  if (job.coat && job.coat->failed()) return status_of(job.coat->error());
  if (waits_for_coat(renderer, shown.fur, job)) return failure(Code::unavailable, "its coat is being baked");
  renderer.grow(shown.fur);
  return draw_shown(renderer, job, std::move(shown), passed);
}

Result<DrawnFrame> FrameService::Impl::draw_shown(Renderer& renderer, FrameJob& job, ShownScene shown,
                                                  const Stopwatch& passed) {
  const FrameRequest& request = job.order.request;
  DrawnFrame frame{.revision = shown.revision(), .placement = shown.placement, .estimate = job.order.plan.estimate};
  frame.timings.queue = job.since_request.milliseconds() - passed.milliseconds();
  frame.timings.upload = passed.milliseconds();
  const double paused = job.paused;
  DrawTimes times;
  Result<DrawnPicture> picture = draw_for_format(renderer, shown.fur, job.linear ? linear_request(request) : request,
                                                 times, [&] { return run_interleaved(renderer, job); });
  memory.measure(renderer, shown.copy_id());
  const bool of_frame = picture || renderer.lost_gl();  // a lost GL is renewed
  count(passed.milliseconds() - (job.paused - paused), of_frame ? Status{} : picture.status());
  if (job.given_up && job.overdue) return too_slow(request, job.order.plan.cost);
  if (job.given_up) return job.outdated || !job.order.is_abandoned() ? server_stopping() : left_alone();
  ++drawn;
  if (!picture) return picture.status();
  frame.timings.draw = times.draw, frame.timings.cpu = times.cpu;
  if (frame.estimate && times.counters.redrawn == 1 && !request.crop)
    planner.record_cost(request, shown.fur, *frame.estimate, frame.timings.draw);
  frame.counters = times.counters;
  frame.picture = std::move(*picture);
  frame.frame = std::make_shared<const FurFrame>(std::move(shown.fur));
  return frame;
}

bool FrameService::Impl::waits_for_coat(const Renderer& renderer, const FurFrame& frame, FrameJob& job) {
  if (!renderer.misses_coat(frame)) return job.coat = nullptr, false;
  if (!job.coat || !job.coat->fits(frame.coat())) job.coat = baker.submit(frame.coat());
  return job.put_back = !job.coat->settled();
}

void FrameService::Impl::add(std::unique_ptr<FrameJob> job) {
  const std::lock_guard lock(mutex);
  std::unique_ptr<FrameJob>* older = jobs.find([&](const auto& other) { return other->same_view(*job); });
  if (older) {  // the new frame takes its place in the queue
    (*older)->answer.set_value(failure(Code::conflict, "superseded by a newer frame of the same view"));
    job->coat = std::move((*older)->coat);
    *older = std::move(job);
  } else {
    const double cost = job->cost();
    const JobOwner subject{std::hash<Scene*>()(job->order.scene.get()),
                           std::hash<std::string>()(job->order.request.view)};
    jobs.add(std::move(job), cost, running_time.milliseconds(), subject);
  }
  wake.notify_one();
}

Result<DrawnFrame> FrameService::Impl::submit(FrameJob job) {
  std::future<Result<DrawnFrame>> answer = job.answer.get_future();
  add(std::make_unique<FrameJob>(std::move(job)));
  return answer.get();
}

}  // namespace pelage
