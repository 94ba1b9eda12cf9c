// What frames of both methods, shells and strands, have beside their picture.
#pragma once

#include <glm/glm.hpp>

#include "base/status.h"

namespace pelage {

inline Status server_stopping() { return failure(Code::unavailable, "the server is stopping"); }

/// Milliseconds of each stage, for Server-Timing. Of a traced picture `draw` is of what lies under the strands.
struct FrameTimings {
  double queue = 0, upload = 0, draw = 0, read = 0, encode = 0;
  double cpu = 0;  // of what is not traced: of all threads of the server while `draw` passed
};

/// From the renderer's coordinates to the model's own: internal * size + centre.
struct ModelPlacement {
  glm::dvec3 centre{0};
  double size = 1;
};

}  // namespace pelage
