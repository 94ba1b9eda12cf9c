// The dial: estimates of a frame's error and cost, and the calibration of a machine.
#pragma once

#include <string>
#include <vector>

#include "protocol/commands/frame.h"

namespace pelage {

/// Why a frame has the knobs that it has.
enum class PlanEnd {
  asked,    // the request named them
  budget,   // better ones cost more than the budget
  error,    // the cheapest that keep the error
  best,     // nothing better is known: budget is left, or the error cannot be kept
  cheapest  // even the cheapest cost more than the budget
};

/// The estimate of a frame of rasterized strands, before it is drawn. Error is the mean LDR-FLIP over the fur's mask
/// against the same strands, traced (R2 of science.md 6). Cost is the drawing time on this machine in milliseconds.
struct FrameEstimate {
  double error = 0;         // median error of the frames in views like it, [0, 1]
  double error_safety = 1;  // 1 or more: 95% of frames have at most error times it
  double cost_ms = 0;
  double cost_safety = 1;  // the same of cost
  double correction = 1;   // measured over predicted cost of this scene so far; cost_ms includes it
  PlanEnd end = PlanEnd::asked;
  std::string calibration;  // its name
  bool operator==(const FrameEstimate&) const = default;
};

/// What a frame is expected to take before it is drawn: the answer of a dry run.
struct FrameCost {
  double seconds = 0;  // half of such frames take as long or shorter
  double safety = 1;   // 1 or more: 95% of them are done after seconds times it
  bool operator==(const FrameCost&) const = default;
};

/// A frame that is drawn or waits to be.
struct FrameProgress {
  std::string view;
  int width = 0, height = 0;
  double share = 0;             // of the expected drawing time that has passed, [0, .99]; 0 while it waits
  double seconds = 0;           // since it was asked for
  double expected_seconds = 0;  // that drawing it takes
  bool operator==(const FrameProgress&) const = default;
};

struct FrameProgressList {
  std::vector<FrameProgress> frames;
  bool operator==(const FrameProgressList&) const = default;
};

/// The measured drawing speed of a machine.
struct Calibration {
  std::string name = "defaults";
  std::string machine;  // what draws (drawn_by); "" for any
  int threads = 0;      // that it draws on; 0 for any
  double price = 1;     // its milliseconds over those of the default prices, above 0
  bool operator==(const Calibration&) const = default;
};

}  // namespace pelage
