// What drawing a frame took.
#pragma once

#include "protocol/commands/answers.h"

namespace pelage {

/// Milliseconds of a frame's stages, and what it asked of the GL.
struct DrawTimes {
  double shadow = 0, draw = 0, read = 0;
  double cpu = 0;  // of all threads of the process while `shadow` and `draw` passed
  FrameCounters counters;
};

/// Adds what was counted; `redrawn` stays.
void add_counts(FrameCounters& total, const FrameCounters& more);
/// Adds another drawing's.
void add_times(DrawTimes& total, const DrawTimes& more);

}  // namespace pelage
