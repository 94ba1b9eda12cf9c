#include "server/frames/frame_service.h"

#include <algorithm>
#include <atomic>
#include <condition_variable>
#include <deque>
#include <functional>
#include <future>
#include <mutex>
#include <optional>
#include <thread>
#include <utility>

#include "protocol/base/caught.h"
#include "protocol/base/stopwatch.h"
#include "renderer/frame/renderer.h"
#include "renderer/image/cropped.h"
#include "server/frames/frame_file.h"
#include "server/frames/frame_job.h"
#include "server/frames/frame_planner.h"
#include "server/frames/frame_queue.h"
#include "server/frames/missed_goals.h"
#include "server/frames/renderer_memory.h"
#include "server/frames/shown_scene.h"

namespace pelage {

namespace {

/// What tracing needs of the render thread; null when that is stopping.
using Task = std::function<void(Renderer*)>;

constexpr int max_restarts = 2;                       // of a frame whose scene changed meanwhile
constexpr std::size_t max_running = 4;                // frames that were let in one by another: each holds its picture
constexpr std::chrono::milliseconds look_again{250};  // at whether clients of frames that wait have left

/// Each bakes on two threads, beside the one that draws.
int baking_threads() { return std::max(1, default_threads() / 4); }

void encode_answer(FrameAnswer& answer, DrawnPicture picture, const FrameRequest& request,
                   const ModelPlacement& placement, PngEncoder& png, const FileTexts& texts) {
  const Stopwatch passed;
  answer.bytes = encode_frame(std::move(picture), request, answer.knobs, placement, png,
                              texts ? texts(answer) : std::vector<ImageText>());
  answer.timings.encode = passed.milliseconds();
}

}  // namespace

struct FrameService::Impl {
  Impl(ContextSource source, YieldGate& yield_gate, std::size_t coat_memory, int asked_threads)
      : contexts(std::move(source)),
        gate(yield_gate),
        baker(baking_threads(), coat_memory, [this] { wake_up(); }),
        threads(drawing_threads(asked_threads)),
        png(threads) {}

  const ContextSource contexts;
  std::unique_ptr<Context> context;  // of the render thread; null where there is no GL
  YieldGate& gate;
  std::mutex mutex;
  std::condition_variable wake;
  CoatBaker baker;
  ShortestFirst<std::unique_ptr<FrameJob>> jobs;
  std::deque<Task> tasks;  // after all jobs
  std::vector<std::uint64_t> forgotten;
  bool stopping = false;
  std::string description;
  std::atomic<bool> healthy{true};
  std::atomic<std::size_t> drawn{0}, lost_contexts{0};
  std::atomic<double> seconds{0};
  RendererMemory memory;
  PastScenes past_scenes;
  MovedFur moved_fur;  // of the render thread
  FramePlanner planner;
  const int threads;  // that fur is drawn on
  PngEncoder png;     // of whoever asked, not of the render thread
  const Stopwatch running_time;
  std::vector<FrameJob*> running;  // on the render thread; each was let in by the one before it
  std::thread thread;

  void run(std::promise<Status>& started);
  void serve(Renderer& renderer);
  /// Waits for something to do and does it; false at the end.
  bool serve_next(Renderer& renderer);
  void wake_up() {
    const std::lock_guard lock(mutex);
    wake.notify_one();
  }
  /// Whether the render thread has anything to do. Needs the lock.
  bool has_work() const;
  /// Whether the frame waits for its coat to be baked, which it then asks for.
  bool waits_for_coat(const Renderer& renderer, const FurFrame& frame, FrameJob& job);
  /// Drops the copies of models that are gone; whether there were any. Needs the lock.
  bool forget_gone(Renderer& renderer);
  /// Draws a job that was taken and answers it, or puts it back where its coat is not there yet.
  void finish(Renderer& renderer, ShortestFirst<std::unique_ptr<FrameJob>>::Taken taken);
  Result<DrawnFrame> draw(Renderer& renderer, FrameJob& job);
  /// Between the pieces of a job: draws those that wait now and are short beside it. Whether the job goes on.
  bool let_in(Renderer& renderer, FrameJob& job);
  /// In place of a GL that is lost: another one, or none where none is to be had.
  void renew_gl(Renderer& renderer);
  /// Running frames of the job's scene that show another revision have to begin anew.
  void mark_outdated(const FrameJob& job);
  void count(double milliseconds, const Status& outcome);
  void add(std::unique_ptr<FrameJob> job);
  /// Adds a job and waits for its frame. Fails as past_of and `draw` do.
  Result<DrawnFrame> ask(FrameJob job);
  /// Runs `work` on the render thread and waits for it.
  template <class T>
  Result<T> run_task(const std::function<Result<T>(Renderer&)>& work);
};

void FrameService::Impl::run(std::promise<Status>& started) {
  Result<std::unique_ptr<Context>> opened = contexts();
  if (!opened) return started.set_value(opened.status());
  context = std::move(*opened);
  planner.use(default_calibration(threads));
  Result<std::unique_ptr<Renderer>> renderer =
      make_renderer(context.get(), threads, [this](const Coat& coat) { return baker.wait(coat); });
  if (!renderer) return started.set_value(renderer.status());
  description = drawn_by(context.get());
  started.set_value({});
  serve(**renderer);
  renderer->reset(), context.reset();  // GL objects before their context
}

void FrameService::Impl::renew_gl(Renderer& renderer) {
  ++lost_contexts;
  static_cast<void>(renderer.take_gl(nullptr));
  context.reset();
  Result<std::unique_ptr<Context>> opened = contexts();
  if (!opened || !*opened) return;
  context = std::move(*opened);
  if (!renderer.take_gl(&context->gl()).ok()) context.reset();
}

bool FrameService::Impl::has_work() const {
  const auto ready = [](const std::unique_ptr<FrameJob>& job) { return job->ready(); };
  return stopping || jobs.any(ready) || !tasks.empty() || !forgotten.empty() || past_scenes.has_gone();
}

void FrameService::Impl::serve(Renderer& renderer) {
  // What is thrown beside a frame's drawing has lost one job, whose client is told so; the others are served.
  for (Result<bool> go_on = true; !go_on || *go_on;) go_on = caught([&] { return Result<bool>(serve_next(renderer)); });
  while (auto job = jobs.take()) job->job->answer.set_value(server_stopping());
  for (const Task& task : tasks) task(nullptr);
  tasks.clear();
}

bool FrameService::Impl::serve_next(Renderer& renderer) {
  const auto ready = [](const std::unique_ptr<FrameJob>& waiting) { return waiting->ready(); };
  std::optional<ShortestFirst<std::unique_ptr<FrameJob>>::Taken> job;
  Task task;
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
  if (forgot) give_memory_back();
  if (job) finish(renderer, std::move(*job));
  if (task) task(&renderer);
  return true;
}

bool FrameService::Impl::forget_gone(Renderer& renderer) {
  std::vector<std::uint64_t> gone = past_scenes.take_gone();
  gone.insert(gone.end(), forgotten.begin(), forgotten.end());
  forgotten.clear();
  if (gone.empty()) return false;
  for (const std::uint64_t model : gone)
    renderer.forget(model), memory.forget(renderer, model), moved_fur.forget(model);
  return true;
}

void FrameService::Impl::finish(Renderer& renderer, ShortestFirst<std::unique_ptr<FrameJob>>::Taken taken) {
  FrameJob& job = *taken.job;
  job.cost = taken.cost, job.begun = {};
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
  for (; renderer.lost_gl(); ++job.lost_contexts) {  // its coat may have to be baked again, so that it waits in between
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

bool FrameService::Impl::let_in(Renderer& renderer, FrameJob& job) {
  const Stopwatch passed;
  const auto may = [&](const std::unique_ptr<FrameJob>& other) {
    return other->ready() && (job.restarts < max_restarts || !other->same_subject(job));
  };
  // Once it has taken longer than was expected, others are short beside it.
  const double taken = job.begun.milliseconds() - job.paused;
  auto next = [&, moment = std::optional<std::uint64_t>()]() mutable {
    const std::lock_guard lock(mutex);
    job.given_up = job.given_up || stopping;
    if (!moment) moment = jobs.moment();
    if (running.size() >= max_running) return std::optional<ShortestFirst<std::unique_ptr<FrameJob>>::Taken>();
    return jobs.take_beside(std::max(job.cost, taken), *moment, may);
  };
  while (auto other = next()) finish(renderer, std::move(*other));
  job.overdue = taken > 1e3 * job.request.max_seconds;
  job.given_up = job.given_up || job.outdated || job.overdue || job.left();
  const std::lock_guard lock(mutex);
  job.paused += passed.milliseconds();
  return !job.given_up;
}

void FrameService::Impl::mark_outdated(const FrameJob& job) {
  for (FrameJob* other : running)
    other->outdated = other->outdated || (other->same_subject(job) && !other->shows_same(job));
}

void FrameService::Impl::count(double milliseconds, const Status& outcome) {
  seconds = seconds + milliseconds / 1e3;
  if (outcome.code == Code::unavailable) healthy = false;
}

Result<DrawnFrame> FrameService::Impl::draw(Renderer& renderer, FrameJob& job) {
  const Status left = failure(Code::unavailable, "nobody waits for this frame any more");
  if (job.left()) return left;
  DrawnFrame frame;
  frame.timings.queue = job.asked.milliseconds();
  const Stopwatch passed;
  const double paused = job.paused;
  Result<Shown> shown = show(renderer, *job.scene, job.request, job.past, past_scenes, moved_fur, false, true);
  if (!shown) return shown.status();
  job.revision = shown->revision, job.moment = shown->moment;
  mark_outdated(job);
  frame.estimate = planner.plan(job.request, *shown->features, shown->fur);
  frame.cost = planner.cost_of(*shown->features, shown->fur);
  frame.cost.seconds *= job.request.drawn_share();
  if (const Status can = renderer.can_draw(shown->fur); !can.ok()) return can;
  if (job.dry_run) return frame;
  if (Status long_drawing = check_seconds(job.request, frame.cost); !long_drawing.ok()) return long_drawing;
  if (job.coat && job.coat->failed()) return status_of(job.coat->error());
  if (waits_for_coat(renderer, shown->fur, job)) return failure(Code::unavailable, "its coat is being baked");
  {
    const std::lock_guard lock(mutex);
    job.expected = 1e3 * frame.cost.seconds;
  }
  renderer.grow(shown->fur);
  frame.revision = shown->revision, frame.placement = shown->placement;
  frame.timings.upload = passed.milliseconds() - (job.paused - paused);
  DrawTimes times;
  Result<DrawnPicture> picture =
      draw_for_format(renderer, shown->fur, job.linear ? linear_request(job.request) : job.request, times,
                      [&] { return let_in(renderer, job); });
  memory.measure(renderer, shown->copy_id);
  const bool of_frame = picture || renderer.lost_gl();  // what is lost comes again
  count(passed.milliseconds() - (job.paused - paused), of_frame ? Status{} : picture.status());
  if (job.given_up && job.overdue) return too_slow(job.request, frame.cost);
  if (job.given_up) return job.outdated || !job.left() ? server_stopping() : left;
  ++drawn;
  if (!picture) return picture.status();
  frame.timings.draw = times.draw;
  frame.timings.cpu = times.cpu;
  if (frame.estimate && times.counters.redrawn == 1 && !job.request.crop)
    planner.learn(job.request, shown->fur, *frame.estimate, frame.timings.draw);
  frame.counters = times.counters;
  frame.picture = std::move(picture).value();
  frame.frame = std::make_shared<const FurFrame>(std::move(shown->fur));
  return frame;
}

bool FrameService::Impl::waits_for_coat(const Renderer& renderer, const FurFrame& frame, FrameJob& job) {
  if (!renderer.misses_coat(frame)) return job.coat = nullptr, false;
  if (!job.coat || !job.coat->fits(frame.coat)) job.coat = baker.ask(frame.coat);
  return job.put_back = !job.coat->settled();
}

template <class T>
Result<T> FrameService::Impl::run_task(const std::function<Result<T>(Renderer&)>& work) {
  std::promise<Result<T>> promise;
  std::future<Result<T>> answer = promise.get_future();
  {
    const std::lock_guard lock(mutex);
    if (stopping) return server_stopping();
    tasks.push_back([&](Renderer* renderer) {
      promise.set_value(caught([&] { return renderer ? work(*renderer) : Result<T>(server_stopping()); }));
    });
    wake.notify_one();
  }
  return answer.get();
}

void FrameService::Impl::add(std::unique_ptr<FrameJob> job) {
  const std::lock_guard lock(mutex);
  std::unique_ptr<FrameJob>* older = jobs.find([&](const auto& other) { return other->same_view(*job); });
  if (older) {  // whose turn it takes
    (*older)->answer.set_value(failure(Code::conflict, "superseded by a newer frame of the same view"));
    job->coat = std::move((*older)->coat);
    *older = std::move(job);
  } else {
    const double cost = job->dry_run ? 0 : expected_cost(job->request);
    const Subject subject{std::hash<Scene*>()(job->scene.get()), std::hash<std::string>()(job->request.view)};
    jobs.add(std::move(job), cost, running_time.milliseconds(), subject);
  }
  wake.notify_one();
}

Result<DrawnFrame> FrameService::Impl::ask(FrameJob job) {
  Result<FramePast> past = past_of(*job.scene, job.request, past_scenes);
  if (!past) return past.status();
  job.past = std::move(*past);
  std::future<Result<DrawnFrame>> answer = job.answer.get_future();
  add(std::make_unique<FrameJob>(std::move(job)));
  return answer.get();
}

FrameService::FrameService(std::unique_ptr<Impl> impl) : impl_(std::move(impl)) {}

Result<std::unique_ptr<FrameService>> FrameService::start(ContextSource contexts, int threads, YieldGate& gate,
                                                          std::size_t coat_memory) {
  auto impl = std::make_unique<Impl>(std::move(contexts), gate, coat_memory, threads);
  std::promise<Status> started;
  std::future<Status> outcome = started.get_future();
  impl->thread = std::thread([&started, raw = impl.get()] { raw->run(started); });
  const Status status = outcome.get();
  if (!status.ok()) {
    impl->thread.join();
    return status;
  }
  return std::unique_ptr<FrameService>(new FrameService(std::move(impl)));
}

FrameService::~FrameService() {
  {
    const std::lock_guard lock(impl_->mutex);
    impl_->stopping = true;
  }
  impl_->wake.notify_one();
  impl_->thread.join();
}

Result<FrameAnswer> FrameService::frame(const std::shared_ptr<Scene>& scene, const FrameRequest& request,
                                        const std::function<bool()>& abandoned, const FileTexts& texts) {
  const YieldGate::Turn turn = impl_->gate.go_first();
  Result<DrawnFrame> drawn =
      impl_->ask(FrameJob{.scene = scene, .request = request, .abandoned = abandoned, .answer = {}});
  if (!drawn) return drawn.status();
  FrameAnswer result{.bytes = {},
                     .content_type = content_type_of(request.format),
                     .revision = drawn->revision,
                     .knobs = drawn->frame->knobs,
                     .timings = drawn->timings,
                     .counters = drawn->counters,
                     .estimate = std::move(drawn->estimate)};
  result.missed = missed_goals(request, result);
  encode_answer(result, std::move(drawn->picture), request, drawn->placement, impl_->png, texts);
  return result;
}

Result<LinearPicture> FrameService::light(const std::shared_ptr<Scene>& scene, const FrameRequest& request,
                                          const std::function<bool()>& abandoned) {
  const YieldGate::Turn turn = impl_->gate.go_first();
  Result<DrawnFrame> drawn =
      impl_->ask(FrameJob{.scene = scene, .request = request, .abandoned = abandoned, .linear = true, .answer = {}});
  if (!drawn) return drawn.status();
  LinearPicture picture{.revision = drawn->revision,
                        .report = {},
                        .aovs = std::get<std::vector<FloatImage>>(std::move(drawn->picture)),
                        .frame = std::move(drawn->frame),
                        .placement = drawn->placement,
                        .timings = drawn->timings,
                        .counters = drawn->counters};
  if (!request.crop) return picture;
  for (FloatImage& aov : picture.aovs)
    aov = placed(aov, request.crop->left, request.crop->top, request.width, request.height);
  return picture;
}

Result<FrameCost> FrameService::cost(const std::shared_ptr<Scene>& scene, const FrameRequest& request) {
  FrameJob job{.scene = scene, .request = request, .abandoned = {}, .dry_run = true, .answer = {}};
  job.request.view.clear();  // it takes nobody's turn
  const Result<DrawnFrame> frame = impl_->ask(std::move(job));
  if (!frame) return frame.status();
  return frame->cost;
}

FrameProgressList FrameService::progress(const Scene& scene) const {
  FrameProgressList list;
  const std::lock_guard lock(impl_->mutex);
  for (const FrameJob* job : impl_->running)
    if (job->scene.get() == &scene && !job->dry_run) list.frames.push_back(progress_of(*job, job->cost, true));
  impl_->jobs.for_each([&](const std::unique_ptr<FrameJob>& job, double cost) {
    if (job->scene.get() == &scene && !job->dry_run) list.frames.push_back(progress_of(*job, cost, false));
  });
  return list;
}

Result<TraceStart> FrameService::begin_trace(const std::shared_ptr<Scene>& scene, const FrameRequest& request) {
  Result<FramePast> past = past_of(*scene, request, impl_->past_scenes);
  if (!past) return past.status();
  const Stopwatch asked;
  return impl_->run_task<TraceStart>([&](Renderer& renderer) -> Result<TraceStart> {
    FrameTimings timings{.queue = asked.milliseconds()};
    const Stopwatch passed;
    Result<Shown> shown = show(renderer, *scene, request, *past, impl_->past_scenes, impl_->moved_fur, true, false);
    if (!shown) return shown.status();
    timings.upload = passed.milliseconds();
    DrawTimes times;
    Result<Backplate> base = renderer.draw_backplate(shown->fur, &times);
    impl_->memory.measure(renderer, shown->copy_id);
    impl_->count(passed.milliseconds(), base ? Status{} : base.status());
    if (!base) return base.status();
    timings.draw = times.draw;
    return TraceStart{std::move(*shown->copy),
                      std::move(shown->fur),
                      shown->placement,
                      std::move(*base),
                      timings,
                      times.counters,
                      shown->moment,
                      std::move(shown->direction),
                      past->copy};
  });
}

Result<FrameAnswer> FrameService::finish(const LinearPicture& picture, const FrameRequest& request,
                                         const FileTexts& texts) {
  FrameTimings timings = picture.timings;
  const Stopwatch asked;
  Result<DrawnPicture> finished = crop_of(picture.aovs, request);
  if (!is_linear(request.format)) {  // which is light as it was traced
    finished = impl_->run_task<DrawnPicture>([&](Renderer& renderer) {
      const Stopwatch passed;
      Result<DrawnPicture> shown = finish_for_format(renderer, *picture.frame, request, picture.aovs.front());
      impl_->count(passed.milliseconds(), shown ? Status{} : shown.status());
      return shown;
    });
  }
  if (!finished) return finished.status();
  timings.read += asked.milliseconds();
  FrameAnswer answer{.bytes = {},
                     .content_type = content_type_of(request.format),
                     .revision = picture.revision,
                     .knobs = knobs_of(picture),
                     .timings = timings,
                     .counters = picture.counters,
                     .trace = picture.report};
  answer.missed = missed_goals(request, answer);
  encode_answer(answer, std::move(*finished), request, picture.placement, impl_->png, texts);
  return answer;
}

std::size_t FrameService::copy_bytes(std::uint64_t model_id) const {
  std::size_t bytes = impl_->memory.of_copies(model_id);
  for (const PastCopy& copy : impl_->past_scenes.kept(model_id))
    bytes += copy->bytes() + impl_->memory.of_copies(copy->view().copy_id);
  return bytes;
}
std::size_t FrameService::coat_bytes() const { return impl_->baker.bytes(); }
std::uint64_t FrameService::coats_baked() const { return impl_->baker.baked(); }
std::size_t FrameService::gl_bytes() const { return impl_->memory.of_gl(); }

void FrameService::forget(std::uint64_t model_id) {
  impl_->past_scenes.forget(model_id);
  const std::lock_guard lock(impl_->mutex);
  impl_->forgotten.push_back(model_id);
  impl_->wake.notify_one();
}

void FrameService::plan_by(Calibration calibration) { impl_->planner.use(std::move(calibration)); }
int FrameService::threads() const { return impl_->threads; }

const std::string& FrameService::description() const { return impl_->description; }
bool FrameService::healthy() const { return impl_->healthy; }
std::size_t FrameService::lost_contexts() const { return impl_->lost_contexts; }
std::size_t FrameService::frames_drawn() const { return impl_->drawn; }
double FrameService::seconds_drawing() const { return impl_->seconds; }

}  // namespace pelage
