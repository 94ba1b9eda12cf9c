// Quality planning (docs/dial.md): estimates of a frame's error and cost, and the calibration of a machine.
#pragma once

#include <string>
#include <vector>

#include "protocol/commands/frame.h"

namespace pelage {

/// Why a frame's knobs were chosen.
enum class PlanEnd {
  asked,    // the request named them
  budget,   // better knobs cost more than the budget
  error,    // the cheapest knobs within the allowed error
  best,     // the best known knobs: budget is left, or the allowed error cannot be met
  cheapest  // even the cheapest knobs cost more than the budget
};

/// The estimate of a frame of rasterized strands, before it is drawn. Error is the mean LDR-FLIP over the fur's mask
/// against the same strands, traced (R2 of science.md 6). Cost is the drawing time on this machine in milliseconds.
struct FrameEstimate {
  double error = 0;         // median error of frames in similar views, [0, 1]
  double error_safety = 1;  // factor, 1 or more: 95% of frames have at most error times this
  double cost_ms = 0;
  double cost_safety = 1;  // the same for cost_ms
  double correction = 1;   // measured over predicted cost of this scene so far; cost_ms includes it
  PlanEnd end = PlanEnd::asked;
  std::string calibration;  // name of the calibration used
  bool operator==(const FrameEstimate&) const = default;
};

/// The predicted drawing time of a frame: the answer to a dry run.
struct FrameCost {
  double seconds = 0;  // median time of such frames
  double safety = 1;   // factor, 1 or more: 95% of such frames take at most seconds times this
  bool operator==(const FrameCost&) const = default;
};

/// A frame that is drawn or waits to be.
struct FrameProgress {
  std::string view;
  int width = 0, height = 0;
  double share = 0;             // share of the expected drawing time that has passed, [0, .99]; 0 while it waits
  double seconds = 0;           // time since the request
  double expected_seconds = 0;  // expected drawing time
  bool operator==(const FrameProgress&) const = default;
};

struct FrameProgressList {
  std::vector<FrameProgress> frames;
  bool operator==(const FrameProgressList&) const = default;
};

/// The measured drawing speed of a machine.
struct Calibration {
  std::string name = "defaults";
  std::string machine;  // what draws, as drawn_by() describes it; "" for any
  int threads = 0;      // threads that it draws on; 0 for any
  double price = 1;     // factor on the cost model's milliseconds, above 0
  bool operator==(const Calibration&) const = default;
};

}  // namespace pelage
