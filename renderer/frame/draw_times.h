// What drawing a frame took.
#pragma once

#include "protocol/commands/answers.h"

namespace pelage {

/// Milliseconds of a frame's stages, and what it asked of the GL.
struct DrawTimes {
  double draw = 0;
  double cpu = 0;  // of all threads of the process while that passed
  FrameCounters counters;
};

}  // namespace pelage
