// Fur in the wind as frames show it: which lean the renderer's copies hold.
#pragma once

#include <cstdint>
#include <glm/glm.hpp>
#include <map>
#include <memory>
#include <optional>
#include <vector>

#include "protocol/commands/frame.h"
#include "server/scene/scene.h"

namespace pelage {

/// A direction field that the wind has moved; null for fur at rest.
using MovedDirection = std::shared_ptr<const std::vector<glm::vec2>>;

/// The scene's at a moment.
MovedDirection moved_at(const SceneView& scene, double moment);

/// The moment at which a frame shows the scene; empty if no wind blows and nothing swings.
std::optional<double> moment_of(const SceneView& scene, const FrameRequest& request);

/// Belongs to the render thread. A renderer's copy of a scene holds one direction field: the scene's own, or that of a
/// moment of one revision.
class MovedFur {
 public:
  struct Shown {
    MovedDirection direction;
    bool whole = false;  // every vertex differs from what the renderer's copy holds
  };
  /// What the renderer is about to be given of the scene. Computes it unless the copy holds it already.
  Shown show(const SceneView& scene, std::optional<double> moment);

  /// Drops what is held for a copy; `copy` is a SceneView::copy_id.
  void forget(std::uint64_t copy) { held_.erase(copy); }

 private:
  struct Held {
    Revision revision = 0;
    double moment = 0;
    MovedDirection direction;
  };
  std::map<std::uint64_t, Held> held_;  // by copy; those at rest are not in it
};

}  // namespace pelage
