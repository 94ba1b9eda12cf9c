// A model that moves while its groom stays: the same triangles elsewhere, and what stands on it goes along.
#pragma once

#include <cstdint>
#include <memory>
#include <span>

#include "base/status.h"
#include "server/history/journal.h"
#include "server/scene/model.h"
#include "server/scene/scene.h"

namespace pelage {

/// Returns the settings with eyes, curves and bare skin moved along with the surface: each moves and turns as a whole
/// with the nearest position of the surface at rest, a curve with that of its root. An eye that looks at a point goes
/// on doing so. `turns` are those of `rest` (surface_turns), `moved` has its triangles.
SceneSettings carried_along(SceneSettings settings, const Surface& rest, const Mesh& moved,
                            std::span<const glm::dmat3> turns);

/// A model of a scene, ready to stand elsewhere.
class MovingModel {
 public:
  /// Of the scene's model, `rest`, as the journal has it in `stored`. Fails as preparing it does.
  static Result<MovingModel> create(const StoredModel& stored, std::shared_ptr<const SceneModel> rest);

  /// Returns the pose of the same model from another file, or from another moment of it. Fields go along by vertex, the
  /// fur's directions turn with the surface, the camera and the lights stay. `id` is the model's, unique in the
  /// process. Refused (invalid) for other numbers of vertices or faces than at rest, or faces of other vertices; for
  /// positions that are not finite or further than 1,000 sizes from the model at rest.
  Result<ScenePose> pose(const RawModel& raw, SceneSettings settings, std::uint64_t id) const;

  /// Refuses what `pose` refuses, without making the pose.
  Status check(const RawModel& raw) const;
  /// Returns only the mesh of the pose. Refused as `pose`.
  Result<Mesh> mesh(const RawModel& raw) const;
  const Mesh& rest() const { return rest_->surface.mesh(); }

 private:
  MovingModel(RawModel raw, StoredModel how, LaidModel laid, std::shared_ptr<const SceneModel> rest);
  Result<LaidMesh> laid(const RawModel& raw) const;

  RawModel raw_;  // positions and faces only
  StoredModel how_;
  LaidModel laid_;
  std::shared_ptr<const SceneModel> rest_;
};

}  // namespace pelage
