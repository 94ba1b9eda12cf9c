// The features of a view of furred skin that determine cost and error, found without drawing.
#pragma once

#include <glm/glm.hpp>
#include <span>

#include "renderer/input/fur_scene.h"

namespace pelage {

/// The skin as it is drawn.
struct FurredSkin {
  std::span<const glm::vec3> positions, normals;
  std::span<const glm::uvec3> triangles;
  std::span<const float> length;  // length of the fur for each vertex, sizes
  double patch_triangles = 1;     // patch triangles for each triangle of the model, 1 or more
};

/// Pixels are those of the requested size. All values are finite and at least 0.
struct ViewFeatures {
  double pixels = 1;      // pixels of the picture
  double area = 0;        // pixels inside the picture that triangles with visible fur cover, overlaps counted again
  double fur_pixels = 0;  // mean length of the visible fur, pixels
  double lights = 0;
  double strands = 0;       // strands of all coats on the skin of `area`
  double width_pixels = 0;  // mean width of a visible strand of the first coat at its root, pixels
  double winding = 1;       // winding of its strands (strand_tile.h)
};

/// Returns the features of a view. Examines at most some ten thousand triangles, evenly spread over the list.
/// Deterministic.
ViewFeatures view_features(const FurFrame& frame, const FurredSkin& skin);

}  // namespace pelage
