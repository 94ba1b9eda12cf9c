// Measures the time that a drawing takes.
#pragma once

#include <time.h>

#include "base/stopwatch.h"
#include "protocol/commands/answers.h"

namespace pelage {

/// What drawing a frame took: milliseconds, and counts of GL calls.
struct DrawTimes {
  double draw = 0;  // elapsed time
  double cpu = 0;   // CPU time of all threads of the process meanwhile
  FrameCounters counters;
};

/// CPU time of all threads of the process, which includes the threads of a software GL.
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

/// Adds the time from its construction to its destruction to a frame's times.
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
