// What the renderer's copies of scenes show: which change of the fields, and fur at which moment of the wind.
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

/// Null for fur at rest.
using MovedDirection = std::shared_ptr<const MovedFur>;

/// The scene's at a moment.
MovedDirection moved_at(const SceneView& scene, double moment);

/// The moment at which a frame shows the scene; empty if no wind blows and nothing swings.
std::optional<double> moment_of(const SceneView& scene, const FrameRequest& request);

/// Belongs to the render thread. A renderer's copy of a scene has the fields after one change, and one direction field:
/// the scene's own, or that of a moment of one revision.
class ShownFur {
 public:
  /// What the copy lacks to show a snapshot.
  struct Difference {
    std::vector<VertexRange> touched;
    MovedDirection direction;  // of the fur at the moment; null for fur at rest
  };
  /// What the copy is about to be given. Computes the direction unless the copy has it already.
  Difference update(const SceneSnapshot& snapshot, std::optional<double> moment);
  /// The copy has been given that. Until then, and where giving it fails, it counts as one that shows nothing.
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
