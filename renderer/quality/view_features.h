// What a view of furred skin has that decides cost and error, found without drawing.
#pragma once

#include <glm/glm.hpp>
#include <span>

#include "renderer/input/fur_scene.h"

namespace pelage {

/// The skin as it is drawn. Fur over vertices, `length` in sizes.
struct FurredSkin {
  std::span<const glm::vec3> positions, normals;
  std::span<const glm::uvec3> triangles;
  std::span<const float> length;  // for each vertex
  double pieces = 1;              // pieces of fur for each triangle, 1 or more
};

/// Pixels are those of the asked size. All finite, 0 or more.
struct ViewFeatures {
  double pixels = 1;      // of the picture
  double area = 0;        // pixels that pieces whose fur is seen cover inside the picture, one over the other
  double fur_pixels = 0;  // length of the fur where it is seen
  double lights = 0;
  double strands = 0;       // of all coats, that stand on the skin of `area`
  double width_pixels = 0;  // of a strand of the first coat at its root where it is seen
  double winding = 1;       // of its strands (strand_tile.h)
};

/// At most some ten thousand triangles are looked at, evenly through the list. Deterministic.
ViewFeatures view_features(const FurFrame& frame, const FurredSkin& skin);

}  // namespace pelage
