// An animated model: the same triangles at other positions. The groom stays, and what stands on the skin moves along.
#pragma once

#include <cstdint>
#include <memory>
#include <span>

#include "base/status.h"
#include "server/history/journal.h"
#include "server/scene/model.h"
#include "server/scene/scene.h"

namespace pelage {

/// Returns the settings with eyes, curves and bare skin moved along with the surface. Each moves rigidly with the
/// position of the rest surface that is nearest to it, a curve with the one nearest to its root. An eye that looks at a
/// point keeps looking at it. `turns` are the rotations of the vertices of `rest` (surface_rotations); `moved` has the
/// triangles of `rest`.
SceneSettings moved_with_surface(SceneSettings settings, const Surface& rest, const Mesh& moved,
                                 std::span<const glm::dmat3> rotations);

/// Computes poses of a scene's model.
class MovingModel {
 public:
  /// Prepares to pose the scene's model `rest`, which the journal has as `stored`. Fails as preparing the model does.
  static Result<MovingModel> create(const StoredModel& stored, std::shared_ptr<const SceneModel> rest);

  /// Returns the pose that another file, or another time of the same file, gives the model. Fields stay with their
  /// vertices, fur directions rotate with the surface, and the camera and the lights stay. `id` is the posed model's,
  /// unique in the process. Refuses (invalid) numbers of vertices or faces that differ from those at rest, faces with
  /// other vertices, and positions that are not finite or farther than 1,000 sizes from the model at rest.
  Result<ScenePose> pose(const RawModel& raw, SceneSettings settings, std::uint64_t id) const;

  /// Refuses the vertices and faces that `pose` refuses, without making the pose.
  Status check(const RawModel& raw) const;
  /// Returns only the mesh of the pose. Fails as `pose` does.
  Result<Mesh> mesh(const RawModel& raw) const;
  const Mesh& rest() const { return rest_->surface.mesh(); }

 private:
  MovingModel(RawModel raw, StoredModel how, UnsubdividedModel patched, std::shared_ptr<const SceneModel> rest);
  Result<PatchedMesh> patched(const RawModel& raw) const;

  RawModel raw_;  // positions and faces only
  StoredModel how_;
  UnsubdividedModel unsubdivided_;
  std::shared_ptr<const SceneModel> rest_;
};

}  // namespace pelage
