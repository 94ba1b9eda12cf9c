#include "server/scene/frame_service.h"

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
#include "server/scene/difference_view.h"
#include "server/scene/frame_file.h"
#include "server/scene/fur_view.h"

namespace pelage {

namespace {

using Clock = std::chrono::steady_clock;

double milliseconds_since(Clock::time_point start) {
  return std::chrono::duration<double, std::milli>(Clock::now() - start).count();
}

struct DrawnFrame {
  DrawnPicture picture;
  ModelPlacement placement;
  Revision revision = 0;
  FrameTimings timings;
  FrameCounters counters;
};

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
  std::mutex mutex;
  std::condition_variable wake;
  std::deque<std::unique_ptr<Job>> jobs;
  std::vector<std::uint64_t> forgotten;
  bool stopping = false;
  std::string description;
  std::atomic<bool> healthy{true};
  std::atomic<std::size_t> drawn{0};
  std::atomic<double> seconds{0};
  std::thread thread;

  void run(GlChoice choice, int threads, std::promise<Status>& started);
  void serve(Renderer& renderer);
  Result<DrawnFrame> draw(Renderer& renderer, Job& job);
  void add(std::unique_ptr<Job> job);
};

void FrameService::Impl::run(GlChoice choice, int threads, std::promise<Status>& started) {
  Result<std::unique_ptr<Context>> context = select_context(choice, threads);
  if (!context) return started.set_value(context.status());
  Result<std::unique_ptr<Renderer>> renderer = Renderer::create((*context)->gl());
  if (!renderer) return started.set_value(renderer.status());
  description = (*context)->description();
  started.set_value({});
  serve(**renderer);
  renderer->reset();  // GL objects before their context
}

void FrameService::Impl::serve(Renderer& renderer) {
  for (;;) {
    std::unique_ptr<Job> job;
    {
      std::unique_lock lock(mutex);
      wake.wait(lock, [&] { return stopping || !jobs.empty() || !forgotten.empty(); });
      for (const std::uint64_t model : std::exchange(forgotten, {})) renderer.forget(model);
      if (stopping) break;
      if (jobs.empty()) continue;
      job = std::move(jobs.front());
      jobs.pop_front();
    }
    job->answer.set_value(draw(renderer, *job));
  }
  for (const std::unique_ptr<Job>& job : jobs) job->answer.set_value(failure(Code::unavailable, "the server is stopping"));
  jobs.clear();
}

Result<DrawnFrame> FrameService::Impl::draw(Renderer& renderer, Job& job) {
  if (job.abandoned && job.abandoned()) return failure(Code::unavailable, "nobody waits for this frame any more");
  DrawnFrame frame;
  frame.timings.queue = milliseconds_since(job.asked);
  const Clock::time_point start = Clock::now();
  FurFrame fur;
  bool comparable = true;
  job.scene->read_for_drawing([&](const SceneView& scene, const std::vector<VertexRange>& dirty) {
    frame.revision = scene.revision;
    fur = make_frame(scene, job.request);
    const Mesh& mesh = scene.model.surface.mesh();
    frame.placement = {mesh.centre, mesh.size};
    sync_scene(renderer, scene, dirty);
    comparable = !job.past || job.past->model.get() == &scene.model;
    if (job.past && comparable) fur.difference = change_shares(job.past->fields, scene.fields);
  });
  if (!comparable) return failure(Code::conflict, "the scene has another model since the frame was asked for");
  frame.timings.upload = milliseconds_since(start);
  DrawTimes times;
  Result<DrawnPicture> picture = draw_for_format(renderer, fur, job.request, times);
  seconds = seconds + milliseconds_since(start) / 1e3;
  ++drawn;
  if (!picture) {
    if (picture.status().code == Code::unavailable) healthy = false;
    return picture.status();
  }
  frame.timings.shadow = times.shadow, frame.timings.draw = times.draw, frame.timings.read = times.read;
  frame.counters = times.counters;
  frame.picture = std::move(picture).value();
  return frame;
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

Result<std::unique_ptr<FrameService>> FrameService::start(GlChoice choice, int threads) {
  auto impl = std::make_unique<Impl>();
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
  auto job = std::make_unique<Job>(Job{.scene = scene, .request = request, .abandoned = abandoned, .answer = {}});
  if (request.overlay == Overlay::difference) {  // read here, where it holds up no other frame
    Result<PastFields> past = scene->past_fields(request.overlay_from.value_or(0));
    if (!past) return past.status();
    job->past = std::move(*past);
  }
  std::future<Result<DrawnFrame>> answer = job->answer.get_future();
  impl_->add(std::move(job));
  Result<DrawnFrame> drawn = answer.get();
  if (!drawn) return drawn.status();
  const Clock::time_point start = Clock::now();
  FrameAnswer result{.octets = encode_frame(std::move(drawn->picture), request, drawn->placement),
                     .content_type = content_type_of(request.format),
                     .revision = drawn->revision,
                     .knobs = request.knobs,
                     .timings = drawn->timings,
                     .counters = drawn->counters};
  result.timings.encode = milliseconds_since(start);
  return result;
}

void FrameService::forget(std::uint64_t model_id) {
  const std::lock_guard lock(impl_->mutex);
  impl_->forgotten.push_back(model_id);
  impl_->wake.notify_one();
}

const std::string& FrameService::description() const { return impl_->description; }
bool FrameService::healthy() const { return impl_->healthy; }
std::size_t FrameService::frames_drawn() const { return impl_->drawn; }
double FrameService::seconds_drawing() const { return impl_->seconds; }

}  // namespace pelage
