// Requests for a position on a model.
#pragma once

#include <glm/glm.hpp>
#include <optional>

#include "protocol/commands/stroke.h"

namespace pelage {

/// A ray from `origin` along `direction`, model coordinates.
struct PickRay {
  glm::dvec3 origin{0}, direction{0, 0, -1};
};

/// Asks for the position of the surface that lies farthest along `direction`, inside the box from `min` to `max` (model
/// coordinates) or, without a box, on the whole model. Of several equally far ones, the one on the first triangle
/// counts.
struct PickFarthest {
  glm::dvec3 direction{0, 1, 0};
  std::optional<glm::dvec3> min = {}, max = {};  // both or none; min is at most max on each axis
};

/// Asks what lies under a pixel of a view, or for the first hit of a ray, the farthest position along a direction, or
/// the nearest one to a point in model coordinates. At most one of the last three is given.
struct PickRequest {
  View view = {};
  glm::dvec2 pixel{0};       // origin top left
  Reach reach = Reach::fur;  // for a pixel: fur also reports the strand that is visible there
  std::optional<PickRay> ray = {};
  std::optional<PickFarthest> farthest = {};
  std::optional<glm::dvec3> nearest = {};
};

}  // namespace pelage
