// Which place of a model is meant.
#pragma once

#include <glm/glm.hpp>
#include <optional>

#include "protocol/commands/stroke.h"

namespace pelage {

/// From `origin`, model coordinates, along `direction`.
struct PickRay {
  glm::dvec3 origin{0}, direction{0, 0, -1};
};

/// The place of the surface that lies farthest along `direction`, of what lies in the box from `min` to `max`, model
/// coordinates; of several the one of the first triangle. The whole model where there is no box.
struct PickFarthest {
  glm::dvec3 direction{0, 1, 0};
  std::optional<glm::dvec3> min = {}, max = {};  // both or none; min nowhere above max
};

/// What lies under a pixel of a view; or the first that a ray hits, or the farthest along a direction, or the nearest
/// to a point in model coordinates. At most one of the last three.
struct PickRequest {
  View view = {};
  glm::dvec2 pixel{0};       // origin top left
  Reach reach = Reach::fur;  // of a pixel: whether the strand that is seen there is told, too
  std::optional<PickRay> ray = {};
  std::optional<PickFarthest> farthest = {};
  std::optional<glm::dvec3> nearest = {};
};

}  // namespace pelage
