#include "server/frames/shown_scene.h"

#include <algorithm>
#include <limits>
#include <utility>
#include <vector>

#include "server/frames/frame_queue.h"
#include "server/frames/fur_view.h"

namespace pelage {

namespace {

Result<Shown> show_once(Renderer& renderer, Scene& scene, const FrameRequest& request, const FramePast& past,
                        MovedFur& fur, bool with_copy, bool with_features) {
  Shown shown;
  bool comparable = true;
  const auto show_view = [&](const SceneView& view, const std::vector<VertexRange>& dirty) {
    shown.revision = view.revision, shown.copy_id = view.copy_id;
    shown.fur = make_frame(view, request);
    const Mesh& mesh = view.model.surface.mesh();
    shown.placement = {mesh.centre, mesh.size};
    shown.moment = moment_of(view, request);
    const MovedFur::Shown moved = fur.show(view, shown.moment);
    const std::vector<VertexRange> all{{0, static_cast<std::uint32_t>(mesh.positions.size())}};
    sync_scene(renderer, view, moved.whole ? all : dirty, moved.direction.get(),
               request.knobs.method == Method::shells);
    shown.direction = moved.direction;
    comparable = !past.compared || past.compared->model.get() == &view.model;
    if (past.compared && comparable) shown.fur.difference = change_shares(past.compared->fields, view.fields);
    if (with_copy) shown.copy.emplace(view);
    if (with_features) shown.features = view_features(shown.fur, furred_skin(view));
  };
  if (past.copy)
    show_view(past.copy->view(), {});  // which never changes
  else
    scene.read_for_drawing(show_view);
  if (comparable) return shown;
  return failure(Code::conflict, "the scene has another model since the frame was asked for");
}

}  // namespace

Result<Shown> show(Renderer& renderer, Scene& scene, const FrameRequest& request, FramePast& past, PastScenes& scenes,
                   MovedFur& fur, bool with_copy, bool with_features) {
  Result<Shown> shown = show_once(renderer, scene, request, past, fur, with_copy, with_features);
  if (!shown || !request.revision || shown->revision == *request.revision) return shown;
  Result<PastCopy> copy = scenes.find(scene, *request.revision);
  if (!copy) return copy.status();
  past.copy = std::move(*copy);
  return show_once(renderer, scene, request, past, fur, with_copy, with_features);
}

Result<FramePast> past_of(const Scene& scene, const FrameRequest& request, PastScenes& scenes) {
  FramePast past;
  if (request.revision) {
    Result<PastCopy> copy = scenes.find(scene, *request.revision);
    if (!copy) return copy.status();
    past.copy = std::move(*copy);
  }
  if (request.overlay != Overlay::difference) return past;
  Result<PastFields> compared = scene.past_fields(request.overlay_from.value_or(0));
  if (!compared) return compared.status();
  past.compared = std::move(*compared);
  return past;
}

namespace {

/// The change that counts as much.
double full_change(Field field, const FieldSet& from, const FieldSet& to) {
  const FieldShape& shape = shape_of(field);
  if (field != Field::length) return shape.channels > 1 ? 1 : double{shape.max} - double{shape.min};
  float longest = std::numeric_limits<float>::min();
  for (const FieldSet* fields : {&from, &to}) {
    for (const float length : fields->length()) longest = std::max(longest, length);
  }
  return longest;
}

}  // namespace

std::vector<float> change_shares(const FieldSet& from, const FieldSet& to) {
  std::vector<float> shares(to.size(), 0.0f);
  for (std::size_t f = 0; f < field_count; ++f) {
    const Field field = field_at(f);
    if (from.at_default(field) && to.at_default(field)) continue;
    const double full = full_change(field, from, to);
    for (std::uint32_t v = 0; v < shares.size(); ++v) {
      const glm::vec4 before = from.value(field, v), after = to.value(field, v);
      if (before == after) continue;
      const double share = glm::length(glm::dvec4(after) - glm::dvec4(before)) / full;
      // The least share that shows: a change is never drawn as none.
      shares[v] = std::max(shares[v], static_cast<float>(std::clamp(share, 1e-6, 1.0)));
    }
  }
  return shares;
}

}  // namespace pelage
