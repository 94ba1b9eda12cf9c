#pragma once

#include <glm/glm.hpp>

namespace pelage {

/// Cameras that the server places itself. `front` looks from +Z; each frames the bare model, never the fur.
enum class AutoView { none, front, back, left, right, top, three_quarter };

/// A pinhole camera in the model's own coordinates (right-handed, Y up). Ignored but for `automatic` unless that is
/// none.
struct Camera {
  AutoView automatic = AutoView::three_quarter;
  glm::dvec3 position{0, 0, 1};
  glm::dvec3 target{0};     // differs from position
  glm::dvec3 up{0, 1, 0};   // not along the view
  double fov_degrees = 35;  // vertical, [1, 150]
};

/// What a pixel sample or a pick refers to: the camera and the size of the frame it was drawn on.
struct View {
  Camera camera;
  int width = 512;   // [1, 8192]
  int height = 512;  // [1, 8192]
};

}  // namespace pelage
