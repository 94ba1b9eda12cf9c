#include "server/frames/frame_service.h"

#include <algorithm>
#include <atomic>
#include <chrono>
#include <condition_variable>
#include <deque>
#include <future>
#include <mutex>
#include <optional>
#include <thread>
#include <utility>

#include "renderer/frame/renderer.h"
#include "server/frames/difference_view.h"
#include "server/frames/error_probe.h"
#include "server/frames/frame_cost.h"
#include "server/frames/frame_file.h"
#include "server/frames/frame_planner.h"
#include "server/frames/fur_view.h"

namespace pelage {

namespace {

using Clock = std::chrono::steady_clock;

Status stopped() { return failure(Code::unavailable, "the server is stopping"); }

double milliseconds_since(Clock::time_point start) {
  return std::chrono::duration<double, std::milli>(Clock::now() - start).count();
}

struct DrawnFrame {
  DrawnPicture picture;
  ModelPlacement placement;
  Revision revision = 0;
  FrameTimings timings;
  FrameCounters counters;
  Knobs knobs;
  std::optional<FrameEstimate> estimate;
};

/// What is drawn of a scene, and which of it.
struct Shown {
  FurFrame fur;
  ModelPlacement placement;
  Revision revision = 0;
  std::optional<SceneCopy> copy = {};
  std::optional<ViewFeatures> features = {};  // where the frame is planned or can be estimated
};

/// What tracing needs of the render thread; null when that is stopping.
using Errand = std::function<void(Renderer*)>;

/// A frame that waits for the render thread.
struct Job {
  std::shared_ptr<Scene> scene;
  FrameRequest request;
  std::function<bool()> abandoned;
  std::optional<PastFields> past = {};  // what the overlay compares with
  Clock::time_point asked = Clock::now();
  std::promise<Result<DrawnFrame>> answer;

  bool same_view(const Job& other) const {
    return !request.view.empty() && scene == other.scene && request.view == other.request.view;
  }
};

}  // namespace

struct FrameService::Impl {
  explicit Impl(YieldGate& yield_gate) : gate(yield_gate) {}

  YieldGate& gate;
  std::mutex mutex;
  std::condition_variable wake;
  std::deque<std::unique_ptr<Job>> jobs;
  std::deque<Errand> errands;  // after all jobs
  std::vector<std::uint64_t> forgotten;
  bool stopping = false;
  std::string description;
  std::atomic<bool> healthy{true};
  std::atomic<std::size_t> drawn{0};
  std::atomic<double> seconds{0};
  FramePlanner planner;
  CostUnit unit;
  PngEncoder png;  // of whoever asked, not of the render thread
  std::thread thread;

  void run(GlChoice choice, int threads, std::promise<Status>& started);
  void serve(Renderer& renderer);
  Result<DrawnFrame> draw(Renderer& renderer, Job& job);
  /// Gives the frame its knobs; `probed` says how long parts of it were drawn for that.
  std::optional<FrameEstimate> plan(Renderer& renderer, const FrameRequest& request, Shown& shown, double& probed);
  void count(Clock::time_point start, const Status& outcome);
  void add(std::unique_ptr<Job> job);
  /// Runs `work` on the render thread and waits for it.
  template <class T>
  Result<T> run_errand(const std::function<Result<T>(Renderer&)>& work);
};

void FrameService::Impl::run(GlChoice choice, int threads, std::promise<Status>& started) {
  Result<std::unique_ptr<Context>> context = select_context(choice, threads);
  if (!context) return started.set_value(context.status());
  Result<std::unique_ptr<Renderer>> renderer = Renderer::create((*context)->gl());
  if (!renderer) return started.set_value(renderer.status());
  description = (*context)->description();
  unit = cost_unit((*context)->is_software(), threads);
  started.set_value({});
  serve(**renderer);
  renderer->reset();  // GL objects before their context
}

void FrameService::Impl::serve(Renderer& renderer) {
  for (;;) {
    std::unique_ptr<Job> job;
    Errand errand;
    {
      std::unique_lock lock(mutex);
      wake.wait(lock, [&] { return stopping || !jobs.empty() || !errands.empty() || !forgotten.empty(); });
      for (const std::uint64_t model : std::exchange(forgotten, {})) renderer.forget(model);
      if (stopping) break;
      if (!jobs.empty()) {
        job = std::move(jobs.front());
        jobs.pop_front();
      } else if (!errands.empty()) {
        errand = std::move(errands.front());
        errands.pop_front();
      }
    }
    if (job) job->answer.set_value(draw(renderer, *job));
    if (errand) errand(&renderer);
  }
  for (const std::unique_ptr<Job>& job : jobs) job->answer.set_value(stopped());
  for (const Errand& errand : errands) errand(nullptr);
  jobs.clear(), errands.clear();
}

/// Brings the renderer's copy of the scene up to date; all of the answer is of one revision.
Result<Shown> show(Renderer& renderer, Scene& scene, const FrameRequest& request, const std::optional<PastFields>& past,
                   bool with_copy, bool with_features) {
  Shown shown;
  bool comparable = true;
  scene.read_for_drawing([&](const SceneView& view, const std::vector<VertexRange>& dirty) {
    shown.revision = view.revision;
    shown.fur = make_frame(view, request);
    const Mesh& mesh = view.model.surface.mesh();
    shown.placement = {mesh.centre, mesh.size};
    sync_scene(renderer, view, dirty);
    comparable = !past || past->model.get() == &view.model;
    if (past && comparable) shown.fur.difference = change_shares(past->fields, view.fields);
    if (with_copy) shown.copy.emplace(view);
    if (with_features) shown.features = view_features(shown.fur, furred_skin(view));
  });
  if (comparable) return shown;
  return failure(Code::conflict, "the scene has another model since the frame was asked for");
}

/// Read by whoever asks, where it holds up no other frame.
Result<std::optional<PastFields>> past_of(const Scene& scene, const FrameRequest& request) {
  if (request.overlay != Overlay::difference) return std::optional<PastFields>();
  Result<PastFields> past = scene.past_fields(request.overlay_from.value_or(0));
  if (!past) return past.status();
  return std::optional(std::move(past).value());
}

void FrameService::Impl::count(Clock::time_point start, const Status& outcome) {
  seconds = seconds + milliseconds_since(start) / 1e3;
  if (outcome.code == Code::unavailable) healthy = false;
}

Result<DrawnFrame> FrameService::Impl::draw(Renderer& renderer, Job& job) {
  if (job.abandoned && job.abandoned()) return failure(Code::unavailable, "nobody waits for this frame any more");
  DrawnFrame frame;
  frame.timings.queue = milliseconds_since(job.asked);
  const Clock::time_point start = Clock::now();
  Result<Shown> shown = show(renderer, *job.scene, job.request, job.past, false, planner.looks_at(job.request));
  if (!shown) return shown.status();
  if (shown->features) frame.estimate = plan(renderer, job.request, *shown, frame.timings.probe);
  frame.knobs = shown->fur.knobs;
  frame.revision = shown->revision, frame.placement = shown->placement;
  frame.timings.upload = milliseconds_since(start);
  DrawTimes times;
  Result<DrawnPicture> picture = draw_for_format(renderer, shown->fur, job.request, times);
  count(start, picture ? Status{} : picture.status());
  ++drawn;
  if (!picture) return picture.status();
  frame.timings.shadow = times.shadow, frame.timings.draw = times.draw, frame.timings.read = times.read;
  frame.timings.cost = unit.of(times);
  if (frame.estimate && times.counters.redrawn == 1) planner.learn(job.request, shown->fur, *frame.estimate, frame.timings.cost);
  frame.counters = times.counters;
  frame.picture = std::move(picture).value();
  return frame;
}

std::optional<FrameEstimate> FrameService::Impl::plan(Renderer& renderer, const FrameRequest& request, Shown& shown,
                                                      double& probed) {
  const Clock::time_point start = Clock::now();
  std::optional<ErrorProbe> probe;
  const MeasureError measure = [&](const Knobs& knobs) {
    if (!probe) probe.emplace(renderer, shown.fur, shown.features->places, truth_shells(*request.max_error));
    return probe->error(knobs);
  };
  std::optional<FrameEstimate> estimate = planner.plan(request, *shown.features, shown.fur, measure);
  if (probe) probed = milliseconds_since(start);
  return estimate;
}

template <class T>
Result<T> FrameService::Impl::run_errand(const std::function<Result<T>(Renderer&)>& work) {
  std::promise<Result<T>> promise;
  std::future<Result<T>> answer = promise.get_future();
  {
    const std::lock_guard lock(mutex);
    if (stopping) return stopped();
    errands.push_back([&](Renderer* renderer) { promise.set_value(renderer ? work(*renderer) : Result<T>(stopped())); });
    wake.notify_one();
  }
  return answer.get();
}

void FrameService::Impl::add(std::unique_ptr<Job> job) {
  const std::lock_guard lock(mutex);
  const auto older = std::find_if(jobs.begin(), jobs.end(), [&](const auto& other) { return other->same_view(*job); });
  if (older != jobs.end()) {
    (*older)->answer.set_value(failure(Code::conflict, "superseded by a newer frame of the same view"));
    *older = std::move(job);
  } else {
    jobs.push_back(std::move(job));
  }
  wake.notify_one();
}

FrameService::FrameService(std::unique_ptr<Impl> impl) : impl_(std::move(impl)) {}

Result<std::unique_ptr<FrameService>> FrameService::start(GlChoice choice, int threads,
                                                          YieldGate& gate) {
  auto impl = std::make_unique<Impl>(gate);
  std::promise<Status> started;
  std::future<Status> outcome = started.get_future();
  impl->thread = std::thread([&started, choice, threads, raw = impl.get()] { raw->run(choice, threads, started); });
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
                                        const std::function<bool()>& abandoned) {
  const YieldGate::Turn turn = impl_->gate.go_first();
  auto job = std::make_unique<Job>(Job{.scene = scene, .request = request, .abandoned = abandoned, .answer = {}});
  Result<std::optional<PastFields>> past = past_of(*scene, request);
  if (!past) return past.status();
  job->past = std::move(*past);
  std::future<Result<DrawnFrame>> answer = job->answer.get_future();
  impl_->add(std::move(job));
  Result<DrawnFrame> drawn = answer.get();
  if (!drawn) return drawn.status();
  const Clock::time_point start = Clock::now();
  FrameAnswer result{.octets = encode_frame(std::move(drawn->picture), request, drawn->placement, impl_->png),
                     .content_type = content_type_of(request.format),
                     .revision = drawn->revision,
                     .knobs = drawn->knobs,
                     .timings = drawn->timings,
                     .counters = drawn->counters,
                     .estimate = std::move(drawn->estimate)};
  result.timings.encode = milliseconds_since(start);
  return result;
}

Result<TraceStart> FrameService::begin_trace(const std::shared_ptr<Scene>& scene, const FrameRequest& request) {
  const Result<std::optional<PastFields>> past = past_of(*scene, request);
  if (!past) return past.status();
  const Clock::time_point asked = Clock::now();
  return impl_->run_errand<TraceStart>([&](Renderer& renderer) -> Result<TraceStart> {
    FrameTimings timings{.queue = milliseconds_since(asked)};
    const Clock::time_point start = Clock::now();
    Result<Shown> shown = show(renderer, *scene, request, *past, true, false);
    if (!shown) return shown.status();
    timings.upload = milliseconds_since(start);
    DrawTimes times;
    Result<BasePicture> base = renderer.draw_base(shown->fur, &times);
    impl_->count(start, base ? Status{} : base.status());
    if (!base) return base.status();
    timings.draw = times.draw, timings.read = times.read;
    return TraceStart{std::move(*shown->copy), std::move(shown->fur), shown->placement, std::move(*base), timings,
                      times.counters};
  });
}

Result<FrameAnswer> FrameService::finish(const TracedPicture& picture, const FrameRequest& request) {
  FrameTimings timings = picture.timings;
  const Clock::time_point asked = Clock::now();
  Result<DrawnPicture> finished = DrawnPicture(picture.layers);
  if (request.format != FrameFormat::exr) {  // an EXR is light as it was traced
    finished = impl_->run_errand<DrawnPicture>([&](Renderer& renderer) {
      const Clock::time_point start = Clock::now();
      Result<DrawnPicture> shown = finish_for_format(renderer, *picture.frame, request, picture.layers.front());
      impl_->count(start, shown ? Status{} : shown.status());
      return shown;
    });
  }
  if (!finished) return finished.status();
  timings.read += milliseconds_since(asked);
  const Clock::time_point start = Clock::now();
  FrameAnswer answer{.octets = encode_frame(std::move(*finished), request, picture.placement, impl_->png),
                     .content_type = content_type_of(request.format),
                     .revision = picture.revision,
                     .knobs = knobs_of(picture),
                     .timings = timings,
                     .counters = picture.counters,
                     .trace = picture.report};
  answer.timings.encode = milliseconds_since(start);
  return answer;
}

void FrameService::forget(std::uint64_t model_id) {
  const std::lock_guard lock(impl_->mutex);
  impl_->forgotten.push_back(model_id);
  impl_->wake.notify_one();
}

void FrameService::plan_by(Calibration calibration) { impl_->planner.use(std::move(calibration)); }
int FrameService::threads() const { return impl_->unit.threads; }

const std::string& FrameService::description() const { return impl_->description; }
bool FrameService::healthy() const { return impl_->healthy; }
std::size_t FrameService::frames_drawn() const { return impl_->drawn; }
double FrameService::seconds_drawing() const { return impl_->seconds; }

}  // namespace pelage
