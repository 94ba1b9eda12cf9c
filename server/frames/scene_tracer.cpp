#include "server/frames/scene_tracer.h"

#include "server/frames/frame_queue.h"
#include "server/frames/fur_view.h"

namespace pelage {

SceneTracer::SceneTracer(FrameService& frames, int threads, std::size_t memory)
    : frames_(frames), tracer_(drawing_threads(threads), memory, true) {}

Result<Revision> SceneTracer::begin(const std::shared_ptr<Scene>& scene, const FrameRequest& request,
                                    const GoOn& go_on) {
  const std::vector<Aov> aovs = linear_aovs(request);
  if (Status refused = tracer_.admit(request.width, request.height, aovs, request.knobs.trace.filter); !refused.ok())
    return refused;
  Result<TraceStart> start = frames_.begin_trace(scene, request);
  if (!start) return start.status();
  ShownScene& shown = start->shown;
  current_ = std::make_unique<TracedPicture>();
  current_->scene = shown.snapshot, current_->masked = request.masked;
  current_->aovs = aovs;
  current_->picture = {.revision = shown.revision(),
                       .report = {},
                       .aovs = {},
                       .frame = std::make_shared<const FurFrame>(std::move(shown.fur)),
                       .placement = shown.placement,
                       .timings = start->timings,
                       .counters = start->counters,
                       .past = request.revision ? shown.snapshot : nullptr};
  const SceneView view = current_->view();
  const double open = request.knobs.trace.shutter;
  const bool blurred = shown.moment && open > 0;
  current_->opening = blurred ? moved_at(view, *shown.moment - open / 2) : shown.direction;
  current_->closing = blurred ? moved_at(view, *shown.moment + open / 2) : nullptr;
  Status status = with_views(*current_, [&](const FurModel& model, const std::vector<FurFields>& fields) {
    return tracer_.begin(model, fields, *current_->picture.frame, std::move(start->base), aovs, go_on);
  });
  if (!status.ok()) return status;
  return current_->picture.revision;
}

std::unique_ptr<PictureTracer::SuspendedPicture> SceneTracer::suspend() {
  current_->traced = tracer_.suspend();
  return std::move(current_);
}

Status SceneTracer::resume(std::unique_ptr<SuspendedPicture> suspended, const GoOn& go_on) {
  current_.reset(static_cast<TracedPicture*>(suspended.release()));
  return with_views(*current_, [&](const FurModel& model, const std::vector<FurFields>& fields) {
    return tracer_.resume(model, fields, std::move(current_->traced), go_on);
  });
}

Status SceneTracer::with_views(const TracedPicture& begun,
                               const std::function<Status(const FurModel&, const std::vector<FurFields>&)>& use) {
  const SceneView view = begun.view();
  const Mesh& mesh = view.model.surface.mesh();
  const std::vector<FurSkinRegion> skin = make_skin(view.settings.skin, mesh);
  const DirtyRange all{0, static_cast<std::uint32_t>(mesh.positions.size())};
  std::vector<FurFields> fields = make_fields(view, skin, std::span(&all, 1), begun.opening.get());
  for (std::size_t c = 0; begun.closing && c < fields.size(); ++c) fields[c].closing = (*begun.closing)[c];
  return use(make_model(view, arrays_of(begun)), fields);
}

LinearPicture SceneTracer::picture() const {
  LinearPicture picture = current_->picture;
  picture.report = tracer_.report();
  for (const Aov aov : current_->aovs) picture.aovs.push_back(tracer_.aov(aov));
  return picture;
}

const ModelArrays& SceneTracer::arrays_of(const TracedPicture& begun) {
  const SceneView now = begun.view();
  const std::uint64_t id = copy_id(now);
  if (!arrays_of_ || &arrays_of_->view().model != &now.model || arrays_id_ != id)
    arrays_ = make_arrays(now), arrays_of_ = begun.scene, arrays_id_ = id;
  return arrays_;
}

}  // namespace pelage
