#include "server/frames/frame_service.h"

#include <algorithm>
#include <future>
#include <mutex>
#include <thread>
#include <utility>

#include "base/stopwatch.h"
#include "renderer/image/cropped.h"
#include "renderer/quality/planner.h"
#include "server/frames/frame_file.h"
#include "server/frames/render_thread.h"

namespace pelage {

namespace {

/// Returns the names of the request's goals that the picture missed, separated by ", "; "" if it met all. `budget_ms`
/// and the `seconds` of tracing are missed if more than budget_margin times as much time passed, `max_error` if the
/// estimated error exceeds it.
std::string missed_goals(const FrameRequest& request, const FrameAnswer& answer) {
  std::string missed;
  const auto name_if = [&](bool is_missed, const char* name) {
    if (is_missed) missed += (missed.empty() ? "" : ", ") + std::string(name);
  };
  const bool traced = answer.trace && answer.trace->passes > 0;
  name_if(!traced && request.budget_ms && answer.timings.draw > *request.budget_ms * budget_margin, "budget_ms");
  name_if(!traced && request.max_error && answer.estimate &&
              std::min(1.0, answer.estimate->error * answer.estimate->error_safety) > *request.max_error,
          "max_error");
  const double seconds = request.knobs.trace.seconds;
  name_if(traced && seconds > 0 && answer.trace->grow_ms + answer.trace->trace_ms > 1e3 * seconds * budget_margin,
          "seconds");
  return missed;
}

}  // namespace

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

Result<FrameView> FrameService::view(const Scene& scene, const FrameRequest& request) {
  return view_of(scene, request, impl_->past_scenes);
}

Result<FramePlan> FrameService::plan(const FrameView& view, const FrameRequest& request) const {
  FramePlan plan = impl_->planner.plan(request, view.snapshot->view());
  if (Status can = impl_->can_draw(plan.knobs); !can.ok()) return can;
  if (Status can = can_encode(request); !can.ok()) return can;
  if (Status long_drawing = check_seconds(request, plan.cost); !long_drawing.ok()) return long_drawing;
  return plan;
}

Result<DrawnFrame> FrameService::draw(FrameOrder order) {
  const YieldGate::Priority priority = impl_->gate.take_priority();
  return impl_->submit(FrameJob{.order = std::move(order)});
}

FrameAnswer FrameService::encode(DrawnFrame drawn, const FrameRequest& request, const FileTexts& texts) {
  const YieldGate::Priority priority = impl_->gate.take_priority();
  const Stopwatch passed;
  FrameAnswer answer{.bytes = {},
                     .content_type = content_type_of(request.format),
                     .revision = drawn.revision,
                     .knobs = knobs_of(*drawn.frame, drawn.trace),
                     .timings = drawn.timings,
                     .counters = drawn.counters,
                     .trace = drawn.trace,
                     .estimate = std::move(drawn.estimate)};
  answer.missed = missed_goals(request, answer);
  std::vector<ImageText> said = texts ? texts(answer) : std::vector<ImageText>();
  if (!texts && request.format == FrameFormat::exr)
    said.push_back({"pelage/revision", std::to_string(answer.revision)});
  answer.bytes =
      encode_frame(std::move(drawn.picture), request, answer.knobs, *drawn.frame, drawn.placement, impl_->png, said);
  answer.timings.encode = passed.milliseconds();
  return answer;
}

Result<LinearPicture> FrameService::draw_linear(const std::shared_ptr<Scene>& scene, const FrameRequest& request,
                                                const std::function<bool()>& abandoned) {
  const YieldGate::Priority priority = impl_->gate.take_priority();
  Result<FrameView> shown = view(*scene, request);
  if (!shown) return shown.status();
  Result<FramePlan> planned = plan(*shown, request);
  if (!planned) return planned.status();
  Result<DrawnFrame> drawn = impl_->submit(
      FrameJob{.order = {scene, request, std::move(*shown), std::move(*planned), abandoned}, .linear = true});
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

FrameProgressList FrameService::progress(const Scene& scene) const {
  FrameProgressList list;
  const std::lock_guard lock(impl_->mutex);
  for (const FrameJob* job : impl_->running)
    if (job->order.scene.get() == &scene) list.frames.push_back(progress_of(*job, true));
  impl_->jobs.for_each([&](const std::unique_ptr<FrameJob>& job) {
    if (job->order.scene.get() == &scene) list.frames.push_back(progress_of(*job, false));
  });
  return list;
}

Result<TraceStart> FrameService::begin_trace(const std::shared_ptr<Scene>& scene, const FrameRequest& request) {
  const Result<FrameView> wanted = view(*scene, request);
  if (!wanted) return wanted.status();
  const Stopwatch since_request;
  return impl_->run_task<TraceStart>([&](Renderer& renderer) -> Result<TraceStart> {
    TraceStart start{.timings = {.queue = since_request.milliseconds()}};
    const Stopwatch passed;
    start.shown = sync_snapshot(renderer, impl_->copy_states, wanted->snapshot, request, wanted->compared.get());
    start.timings.upload = passed.milliseconds();
    DrawTimes times;
    Result<Backplate> base = renderer.draw_backplate(start.shown.fur, &times);
    impl_->memory.measure(renderer, start.shown.copy_id());
    impl_->count(passed.milliseconds(), base ? Status{} : base.status());
    if (!base) return base.status();
    start.base = std::move(*base), start.timings.draw = times.draw, start.counters = times.counters;
    return start;
  });
}

Result<DrawnFrame> FrameService::finish(const LinearPicture& linear, const FrameRequest& request) {
  DrawnFrame drawn{.picture = {},
                   .revision = linear.revision,
                   .frame = linear.frame,
                   .placement = linear.placement,
                   .timings = linear.timings,
                   .counters = linear.counters,
                   .trace = linear.report};
  const Stopwatch since_request;
  Result<DrawnPicture> finished = crop_of(linear.aovs, request);
  if (!is_linear(request.format)) {  // linear formats need no finishing
    finished = impl_->run_task<DrawnPicture>([&](Renderer& renderer) {
      const Stopwatch passed;
      Result<DrawnPicture> shown = finish_for_format(renderer, *linear.frame, request, linear.aovs.front());
      impl_->count(passed.milliseconds(), shown ? Status{} : shown.status());
      return shown;
    });
  }
  if (!finished) return finished.status();
  drawn.picture = std::move(*finished);
  drawn.timings.read += since_request.milliseconds();
  return drawn;
}

std::size_t FrameService::copy_bytes(std::uint64_t model_id) const {
  std::size_t bytes = impl_->memory.of_copies(model_id);
  for (const SnapshotPtr& copy : impl_->past_scenes.cached(model_id))
    bytes += copy->bytes() + impl_->memory.of_copies(copy->copy_id);
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

void FrameService::set_calibration(Calibration calibration) { impl_->planner.set_calibration(std::move(calibration)); }
int FrameService::threads() const { return impl_->threads; }

std::string FrameService::description() const {
  const std::lock_guard lock(impl_->mutex);
  return impl_->description;
}
bool FrameService::healthy() const { return impl_->healthy; }
std::size_t FrameService::lost_contexts() const { return impl_->lost_contexts; }
std::size_t FrameService::frames_drawn() const { return impl_->drawn; }
double FrameService::seconds_drawing() const { return impl_->seconds; }

}  // namespace pelage
