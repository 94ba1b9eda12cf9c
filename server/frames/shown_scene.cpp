#include "server/frames/shown_scene.h"

#include <algorithm>
#include <limits>
#include <utility>
#include <vector>

#include "server/frames/frame_queue.h"
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
