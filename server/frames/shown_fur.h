// The state of the renderer's copies of scenes: the last change of the fields, and the time of moving fur.
#pragma once

#include <cstdint>
#include <map>
#include <memory>
#include <optional>
#include <vector>

#include "protocol/commands/frame.h"
#include "server/frames/moved_fur.h"
#include "server/scene/scene.h"

namespace pelage {

/// Directions of moving fur; null for fur at rest.
using MovedDirection = std::shared_ptr<const MovedFur>;

/// Returns the directions of the scene's fur at a time.
MovedDirection moved_at(const SceneView& scene, double moment);

/// Returns the time at which a frame shows the scene, in seconds; nothing if no wind blows and no body moves.
std::optional<double> moment_of(const SceneView& scene, const FrameRequest& request);

/// Used by the render thread only. A renderer's copy of a scene has the fields as of one change, and one direction
/// field: the scene's own, or that of moving fur at one time and revision.
class RendererCopyStates {
 public:
  /// The data that the copy needs to show a snapshot.
  struct Difference {
    std::vector<VertexRange> touched;
    MovedDirection direction;  // at the time to show; null for fur at rest
  };
  /// Returns the difference to upload, and marks the copy as invalid until taken_over(). Computes the direction unless
  /// the copy has it already.
  Difference update(const SceneSnapshot& snapshot, std::optional<double> moment);
  /// Records that the copy has received the difference. Until then, or if the upload fails, the copy counts as empty.
  void taken_over(const SceneSnapshot& snapshot);

  /// Forgets a copy; `copy` is a SceneView::copy_id.
  void forget(std::uint64_t copy) { copies_.erase(copy); }

 private:
  struct Copy {
    std::optional<std::uint64_t> change;  // RecentChanges::number
    Revision revision = 0;
    std::optional<double> moment = {};
    MovedDirection direction = {};
  };
  std::map<std::uint64_t, Copy> copies_;
};

}  // namespace pelage
