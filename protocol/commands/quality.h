// The dial: how far a frame is estimated to be from the truth, what it is estimated to cost, and the calibration that
// both estimates come from.
#pragma once

#include <array>
#include <cstddef>
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

/// Of a frame of shells, before it is drawn. Error is the mean LDR-FLIP over the fur's mask against the same fur in
/// many sorted shells (R1 of science.md 6). Cost is drawing time: CPU milliseconds of the process while it draws, over
/// the GL's threads; of a hardware GL the milliseconds until it is done.
struct FrameEstimate {
  double error = 0;         // [0, 1]
  double error_safety = 1;  // 1 or more: 95% of frames have at most error times it
  bool measured = false;    // in such a view of the scene; else estimated from the view's features
  double cost_ms = 0;
  double cost_safety = 1;  // the same of cost
  double correction = 1;   // measured over predicted cost of this scene so far, which cost_ms has in it
  PlanEnd end = PlanEnd::asked;
  std::string calibration;  // its name
  bool operator==(const FrameEstimate&) const = default;
};

inline constexpr std::size_t cost_terms = 16;   // renderer/quality/cost_model.h
inline constexpr std::size_t error_traits = 6;  // renderer/quality/error_model.h

/// Knobs that a planner may choose, and their error as a function of a view.
struct CalibratedKnobs {
  Knobs knobs;
  double log_error = 0;                       // natural logarithm, of a view with the lowest of all traits
  std::array<double, error_traits> slopes{};  // added over the range of each trait
  double error_safety = 1;                    // [1, 100]
};

/// What a machine was measured to draw at. Costs belong to the machine, errors hardly.
struct Calibration {
  std::string name = "defaults";
  std::string machine;                    // the GL's description; "" for any
  int threads = 0;                        // that the costs were divided by; 0 for any
  std::array<double, cost_terms> cost{};  // milliseconds for a unit of each term, 0 or more
  double cost_safety = 1;                 // [1, 100], of a scene whose frames have told nothing yet
  double learnt_safety = 1;               // [1, 100], once they have
  double probe_safety = 1;                // [1, 100]: 95% of views have at most the error that was measured times it
  std::array<double, error_traits> low{}, high{};  // of the views that were measured; outside, the nearest counts
  std::vector<CalibratedKnobs> ladder;             // at least one
};

}  // namespace pelage
