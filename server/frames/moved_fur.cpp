#include "server/frames/moved_fur.h"

#include "server/motion/sway.h"

namespace pelage {

MovedDirection moved_at(const SceneView& scene, double moment) {
  const Mesh& mesh = scene.model.surface.mesh();
  const StillFur fur{mesh.positions,           mesh.normals,          mesh.tangents,
                     scene.fields.direction(), scene.fields.length(), scene.fields.values(Field::stiffness)};
  std::optional<BodyMotion> body;
  if (scene.swing) body = BodyMotion{scene.swing->acceleration, scene.swing->step};
  return std::make_shared<const std::vector<glm::vec2>>(
      swayed(fur, scene.settings.wind, moment, body ? &*body : nullptr));
}

std::optional<double> moment_of(const SceneView& scene, const FrameRequest& request) {
  if (!blows(scene.settings.wind) && !scene.swing) return {};
  return request.time.value_or(scene.settings.wind.time);
}

MovedFur::Shown MovedFur::show(const SceneView& scene, std::optional<double> moment) {
  const auto held = held_.find(scene.copy_id);
  if (!moment) {
    if (held == held_.end()) return {};
    held_.erase(held);
    return {nullptr, true};
  }
  if (held != held_.end() && held->second.revision == scene.revision && held->second.moment == *moment)
    return {held->second.direction, false};
  Held& now = held_[scene.copy_id];
  now = {scene.revision, *moment, moved_at(scene, *moment)};
  return {now.direction, true};
}

}  // namespace pelage
