// Times of a drawing.
#pragma once

#include <time.h>

#include "base/stopwatch.h"
#include "protocol/commands/answers.h"

namespace pelage {

/// Milliseconds of a frame's stages, and what it asked of the GL.
struct DrawTimes {
  double draw = 0;
  double cpu = 0;  // of all threads of the process while that passed
  FrameCounters counters;
};

/// CPU time of all threads of the process: what a software GL draws with.
class CpuStopwatch {
 public:
  double milliseconds() const { return now() - start_; }

 private:
  static double now() {
    timespec time{};
    clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &time);
    return static_cast<double>(time.tv_sec) * 1e3 + static_cast<double>(time.tv_nsec) / 1e6;
  }
  double start_ = now();
};

/// Adds the time that it lives to a frame's.
class DrawClock {
 public:
  explicit DrawClock(DrawTimes& times) : times_(times) {}
  ~DrawClock() {
    times_.draw += passed_.milliseconds();
    times_.cpu += worked_.milliseconds();
  }
  DrawClock(const DrawClock&) = delete;
  DrawClock& operator=(const DrawClock&) = delete;

 private:
  DrawTimes& times_;
  Stopwatch passed_;
  CpuStopwatch worked_;
};

}  // namespace pelage
