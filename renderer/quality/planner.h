// Chooses knobs for a time budget or a maximum error. Pure functions: the same arguments give the same choice.
#pragma once

#include <optional>

#include "protocol/commands/quality.h"
#include "renderer/quality/cost_log.h"
#include "renderer/quality/dial_model.h"
#include "renderer/quality/view_features.h"

namespace pelage {

/// The inputs of a choice.
struct PlanBasis {
  const DialModel& model;
  const Calibration& machine;
  const ViewFeatures& view;
  CostCorrection correction = {};  // cost correction of the scene
};

/// The goal: exactly one of the two is set.
struct PlanGoal {
  std::optional<double> budget_ms, max_error;
};

struct PlannedFrame {
  Knobs knobs;
  FrameEstimate estimate;
};

/// Factor by which a frame may exceed its budget; 95% of frames stay within it.
inline constexpr double budget_margin = 1.25;

/// Chooses a row of the model. budget_ms: of the rows whose safe cost is within budget_margin of it, the one with the
/// smallest safe error, else the cheapest row. max_error: of the rows whose safe error is at most that, the cheapest,
/// else the one with the smallest safe error. Of equal rows the first. So a larger budget never gives a larger safe
/// error, and a larger error never a larger estimated cost.
PlannedFrame plan(const PlanBasis& basis, const PlanGoal& goal);

/// Returns the estimate for knobs that a request gives; none if they are not a row of the model.
std::optional<FrameEstimate> estimate_of(const PlanBasis& basis, const Knobs& knobs);

}  // namespace pelage
