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

void encode_answer(FrameAnswer& answer, DrawnPicture picture, const FrameRequest& request,
                   const ModelPlacement& placement, PngEncoder& png, const FileTexts& texts) {
  const Stopwatch passed;
  answer.bytes = encode_frame(std::move(picture), request, answer.knobs, placement, png,
                              texts ? texts(answer) : std::vector<ImageText>());
  answer.timings.encode = passed.milliseconds();
}

/// Names of the request's members that the picture missed, with ", " between them; "" where it kept all. `budget_ms`
/// and `seconds` of tracing are missed where more than budget_margin times as much passed, `max_error` where no knobs
/// are known that keep it.
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

Result<FrameService::Encode> FrameService::begin_frame(const std::shared_ptr<Scene>& scene, const FrameRequest& request,
                                                       const std::function<bool()>& abandoned) {
  const YieldGate::Turn turn = impl_->gate.go_first();
  Result<DrawnFrame> drawn =
      impl_->ask(FrameJob{.scene = scene, .request = request, .abandoned = abandoned, .answer = {}});
  if (!drawn) return drawn.status();
  const auto frame = std::make_shared<DrawnFrame>(std::move(drawn).value());  // a function can be copied, it can not
  return Encode([this, frame, request](const FileTexts& texts) {
    FrameAnswer answer{.bytes = {},
                       .content_type = content_type_of(request.format),
                       .revision = frame->revision,
                       .knobs = frame->frame->knobs,
                       .timings = frame->timings,
                       .counters = frame->counters,
                       .estimate = std::move(frame->estimate)};
    answer.missed = missed_goals(request, answer);
    encode_answer(answer, std::move(frame->picture), request, frame->placement, impl_->png, texts);
    return answer;
  });
}

Result<FrameAnswer> FrameService::frame(const std::shared_ptr<Scene>& scene, const FrameRequest& request,
                                        const std::function<bool()>& abandoned, const FileTexts& texts) {
  const YieldGate::Turn turn = impl_->gate.go_first();  // while it is encoded too
  const Result<Encode> encode = begin_frame(scene, request, abandoned);
  return encode ? (*encode)(texts) : Result<FrameAnswer>(encode.status());
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

std::string FrameService::description() const {
  const std::lock_guard lock(impl_->mutex);
  return impl_->description;
}
bool FrameService::healthy() const { return impl_->healthy; }
std::size_t FrameService::lost_contexts() const { return impl_->lost_contexts; }
std::size_t FrameService::frames_drawn() const { return impl_->drawn; }
double FrameService::seconds_drawing() const { return impl_->seconds; }

}  // namespace pelage
