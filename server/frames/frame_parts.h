// Data that accompanies the picture of every frame, whatever its method.
#pragma once

#include <glm/glm.hpp>

#include "base/status.h"

namespace pelage {

inline Status server_stopping() { return failure(Code::unavailable, "the server is stopping"); }

/// Milliseconds of each stage, for Server-Timing. For a traced picture `draw` is the time of the backplate.
struct FrameTimings {
  double queue = 0, upload = 0, draw = 0, read = 0, encode = 0;
  double cpu = 0;  // CPU time of all threads of the server during `draw`
};

/// The map from internal coordinates to the model's own: internal * size + centre.
struct ModelPlacement {
  glm::dvec3 centre{0};
  double size = 1;
};

}  // namespace pelage
