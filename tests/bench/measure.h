// What the programs that measure frames share: costs on a loaded machine, and a renderer.
#pragma once

#include <functional>
#include <memory>
#include <vector>

#include "renderer/frame/renderer.h"
#include "renderer/gl/context/context.h"
#include "tests/support/furred_model.h"

namespace pelage::bench {

struct Cost {
  double wall = 1e300, cpu = 1e300;  // milliseconds
  void least(const Cost& other);
};

/// User and system time of the whole process, so that other processes count little.
Cost measure(const std::function<void()>& work);

/// The least cost of each, after one run that does not count; repetitions alternate between them, so that a machine
/// that gets slower makes all slower.
std::vector<Cost> measure_alternating(const std::vector<std::function<void()>>& works, int repetitions);

struct BenchRenderer {
  std::unique_ptr<Context> context;
  std::unique_ptr<Renderer> renderer;  // dies before its context
};
/// Prints what there is; on failure prints why, and both are null.
BenchRenderer open_renderer();

/// A picture of a frame and what it cost. Ends the program when it cannot be drawn.
Image draw(Renderer& renderer, const FurFrame& frame, DrawTimes* times = nullptr);

/// The number after `name` among the arguments, else `fallback`.
int argument(int count, char** arguments, const char* name, int fallback);

}  // namespace pelage::bench
