#include "server/frames/scene_tracer.h"

#include "server/frames/frame_queue.h"
#include "server/frames/fur_view.h"

namespace pelage {

SceneTracer::SceneTracer(FrameService& frames, int threads, std::size_t memory)
    : frames_(frames), tracer_(drawing_threads(threads), memory, true) {}

Result<Revision> SceneTracer::begin(const std::shared_ptr<Scene>& scene, const FrameRequest& request,
                                    const GoOn& go_on) {
  aovs_ = linear_aovs(request);
  if (Status refused = tracer_.admit(request.width, request.height, aovs_, request.knobs.trace.filter); !refused.ok())
    return refused;
  Result<TraceStart> start = frames_.begin_trace(scene, request);
  if (!start) return start.status();
  const SceneView view = start->scene.view();
  const Mesh& mesh = view.model.surface.mesh();
  const std::vector<FurSkinRegion> skin = make_skin(view.settings.skin, mesh);
  const DirtyRange all{0, static_cast<std::uint32_t>(mesh.positions.size())};
  begun_ = {.revision = view.revision,
            .report = {},
            .aovs = {},
            .frame = std::make_shared<const FurFrame>(std::move(start->frame)),
            .placement = start->placement,
            .timings = start->timings,
            .counters = start->counters,
            .past = std::move(start->past)};
  const double open = request.knobs.trace.shutter;
  const bool blurred = start->moment && open > 0;
  const MovedDirection opening = blurred ? moved_at(view, *start->moment - open / 2) : start->direction;
  const MovedDirection closing = blurred ? moved_at(view, *start->moment + open / 2) : nullptr;
  FurFields fields = make_fields(view, skin, std::span(&all, 1), opening.get());
  if (closing) fields.closing = *closing;
  Status status =
      tracer_.begin(make_model(view, arrays_of(view)), fields, *begun_.frame, std::move(start->base), aovs_, go_on);
  if (!status.ok()) return status;
  return begun_.revision;
}

LinearPicture SceneTracer::picture() const {
  LinearPicture picture = begun_;
  picture.report = tracer_.report();
  for (const Aov aov : aovs_) picture.aovs.push_back(tracer_.aov(aov));
  return picture;
}

const ModelArrays& SceneTracer::arrays_of(const SceneView& scene) {
  if (model_ == scene.model_owner && backplate_ == scene.picture_owner) return arrays_;
  arrays_ = make_arrays(scene);
  model_ = scene.model_owner, backplate_ = scene.picture_owner;
  return arrays_;
}

}  // namespace pelage
