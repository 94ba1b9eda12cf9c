#include "server/frames/shown_scene.h"

#include <utility>
#include <vector>

#include "server/frames/difference_view.h"
#include "server/frames/frame_cost.h"
#include "server/frames/fur_view.h"

namespace pelage {

Result<Shown> show(Renderer& renderer, Scene& scene, const FrameRequest& request, const std::optional<PastFields>& past,
                   bool with_copy, bool with_features) {
  Shown shown;
  bool comparable = true;
  scene.read_for_drawing([&](const SceneView& view, const std::vector<VertexRange>& dirty) {
    shown.revision = view.revision, shown.copy_id = view.copy_id;
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

Result<std::optional<PastFields>> past_of(const Scene& scene, const FrameRequest& request) {
  if (request.overlay != Overlay::difference) return std::optional<PastFields>();
  Result<PastFields> past = scene.past_fields(request.overlay_from.value_or(0));
  if (!past) return past.status();
  return std::optional(std::move(past).value());
}

}  // namespace pelage
