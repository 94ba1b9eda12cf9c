#include "server/frames/shown_fur.h"

#include <utility>

#include "server/frames/fur_view.h"
#include "server/motion/sway.h"

namespace pelage {

MovedDirection moved_at(const SceneView& scene, double moment) {
  const Mesh& mesh = scene.model.surface.mesh();
  std::optional<BodyMotion> body;
  if (scene.swing) body = BodyMotion{scene.swing->acceleration, scene.swing->step};
  MovedFur moved;
  for (const NamedCoat& coat : visible_coats(scene.settings)) {
    const FieldSet fields = scene.fields.of_coat(coat.id);
    const RestFur fur{mesh.positions,     mesh.normals,    mesh.tangents,
                      fields.direction(), fields.length(), fields.values(Field::stiffness)};
    moved.push_back(swayed(fur, scene.settings.wind, moment, body ? &*body : nullptr));
  }
  return std::make_shared<const MovedFur>(std::move(moved));
}

std::optional<double> moment_of(const SceneView& scene, const FrameRequest& request) {
  if (!has_wind(scene.settings.wind) && !scene.swing) return {};
  return request.time.value_or(scene.settings.wind.time);
}

RendererCopyStates::Difference RendererCopyStates::update(const SceneSnapshot& snapshot, std::optional<double> moment) {
  const SceneView view = snapshot.view();
  Copy& copy = copies_[view.copy_id];
  const bool same_lean = copy.moment == moment && (!moment || copy.revision == view.revision);
  if (!same_lean) copy.direction = moment ? moved_at(view, *moment) : nullptr;
  copy.moment = moment, copy.revision = view.revision;
  std::optional<std::vector<VertexRange>> touched;
  if (same_lean && copy.change) touched = snapshot.changes.since(*copy.change);
  copy.change.reset();
  return {touched ? std::move(*touched) : full_vertex_range(view.fields.size()), copy.direction};
}

void RendererCopyStates::taken_over(const SceneSnapshot& snapshot) {
  copies_.at(snapshot.view().copy_id).change = snapshot.changes.number();
}

}  // namespace pelage
