// From a budget or an error to knobs. Pure: the same arguments give the same choice.
#pragma once

#include <optional>

#include "protocol/commands/quality.h"
#include "renderer/quality/view_features.h"

namespace pelage {

/// Costs of a scene over what its features predict, learnt from its frames (CostLog).
struct CostCorrection {
  double layers = 1, sorted = 1;  // by Knobs::order

  double of(const Knobs& knobs) const { return knobs.order == FragmentOrder::sorted ? sorted : layers; }
  bool operator==(const CostCorrection&) const = default;
};

/// What is asked for: exactly one of them.
struct PlanGoal {
  std::optional<double> budget_ms, max_error;
};

struct PlannedFrame {
  Knobs knobs;
  FrameEstimate estimate;
};

/// How far over its budget a frame may be: 95% of them are not further.
inline constexpr double budget_margin = 1.25;

/// A row of the ladder. budget_ms: the least error of those whose safe cost is within budget_margin of it, else the
/// cheapest. max_error: the cheapest of those whose safe error is at most that, else the one with the least. Of equal
/// ones the first. Rows that a request of this size could not name itself are left out. So more budget never gives a
/// larger estimated error, and a larger error never a larger estimated cost.
PlannedFrame plan(const Calibration& calibration, const ViewFeatures& view, const FurFrame& frame,
                  const CostCorrection& correction, const PlanGoal& goal);

/// The estimate of knobs that a request names; none where they are not on the ladder.
std::optional<FrameEstimate> estimate_of(const Calibration& calibration, const ViewFeatures& view, const Knobs& knobs,
                                         const CostCorrection& correction);

/// Whether frames of this size take the knobs: the limits that requests are held to.
bool fits(const Knobs& knobs, int width, int height);

}  // namespace pelage
