#include "server/frames/shown_scene.h"

#include <algorithm>
#include <limits>
#include <utility>
#include <vector>

#include "server/fields/coats.h"
#include "server/frames/fur_view.h"

namespace pelage {

Result<FrameView> view_of(const Scene& scene, const FrameRequest& request, PastScenes& scenes) {
  FrameView view{scene.snapshot()};
  if (request.revision) {
    Result<SnapshotPtr> past = scenes.find(scene, *request.revision);
    if (!past) return past.status();
    view.snapshot = std::move(*past), view.fixed = true;
  }
  const NamedCoat* coat = find_coat(view.snapshot->settings->coats, request.overlay_coat);
  if (!coat || (coat->muted && !request.overlay_coat.empty()))
    return failure(Code::invalid, "no coat of this name is seen", "/overlay_coat", "a coat that is not muted");
  if (request.overlay != Overlay::difference) return view;
  view.fixed = true;
  const Result<SceneSnapshot> compared = scene.snapshot_at(request.overlay_from.value_or(0), "/overlay_from");
  if (!compared) return compared.status();
  view.compared = compared->fields;
  if (compared->model == view.snapshot->model) return view;
  return failure(Code::conflict, "the scene has another model since the frame was asked for");
}

ShownScene sync_snapshot(Renderer& renderer, RendererCopyStates& shown, const SnapshotPtr& snapshot,
                         const FrameRequest& request, const FieldSet* compared) {
  const SceneView view = snapshot->view(request.masked);
  const Mesh& mesh = view.model.surface.mesh();
  ShownScene now{.snapshot = snapshot, .fur = make_frame(view, request), .placement = {mesh.centre, mesh.size}};
  now.moment = moment_of(view, request);
  const RendererCopyStates::Difference difference = shown.update(*snapshot, now.moment);
  sync_scene(renderer, view, difference.touched, difference.direction.get(), request.knobs.method == Method::shells);
  shown.taken_over(*snapshot);
  now.direction = difference.direction;
  if (compared != nullptr) now.fur.difference = change_shares(*compared, view.fields);
  return now;
}

namespace {

/// Returns the change that counts as 1.
double full_change(Field field, const FieldSet& from, const FieldSet& to) {
  const FieldShape& shape = shape_of(field);
  if (field != Field::length) return shape.channels > 1 ? 1 : double{shape.max} - double{shape.min};
  float longest = std::numeric_limits<float>::min();
  for (const FieldSet* fields : {&from, &to}) {
    for (const float length : fields->length()) longest = std::max(longest, length);
  }
  return longest;
}

/// Raises the shares to those of the changes of one coat.
void add_shares(const FieldSet& from, const FieldSet& to, std::vector<float>& shares) {
  for (std::size_t f = 0; f < field_count; ++f) {
    const Field field = field_at(f);
    if (from.at_default(field) && to.at_default(field)) continue;
    const double full = full_change(field, from, to);
    for (std::uint32_t v = 0; v < shares.size(); ++v) {
      const glm::vec4 before = from.value(field, v), after = to.value(field, v);
      if (before == after) continue;
      const double share = glm::length(glm::dvec4(after) - glm::dvec4(before)) / full;
      // The minimum share keeps any change visible.
      shares[v] = std::max(shares[v], static_cast<float>(std::clamp(share, 1e-6, 1.0)));
    }
  }
}

}  // namespace

std::vector<float> change_shares(const FieldSet& from, const FieldSet& to) {
  std::vector<float> shares(to.size(), 0.0f);
  for (std::size_t coat = 0; coat < std::max(from.coats(), to.coats()); ++coat)
    add_shares(from.of_coat(static_cast<CoatId>(coat)), to.of_coat(static_cast<CoatId>(coat)), shares);
  return shares;
}

}  // namespace pelage
