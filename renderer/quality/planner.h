// From a budget or an error to knobs. Pure: the same arguments give the same choice.
#pragma once

#include <optional>

#include "protocol/commands/quality.h"
#include "renderer/quality/cost_log.h"
#include "renderer/quality/dial_model.h"
#include "renderer/quality/view_features.h"

namespace pelage {

/// What a choice is made by.
struct PlanBasis {
  const DialModel& model;
  const Calibration& machine;
  const ViewFeatures& view;
  CostCorrection correction = {};  // of the scene
};

/// What is asked for: exactly one of them.
struct PlanGoal {
  std::optional<double> budget_ms, max_error;
};

struct PlannedFrame {
  Knobs knobs;
  FrameEstimate estimate;
};

/// How far a frame may exceed its budget: 95% of frames stay within this factor.
inline constexpr double budget_margin = 1.25;

/// A row of the model. budget_ms: the least safe error of those whose safe cost is within budget_margin of it, else
/// the cheapest. max_error: the cheapest of those whose safe error is at most that, else the one with the least. Of
/// equal ones the first. So more budget never gives a larger safe error, and a larger error never a larger estimated
/// cost.
PlannedFrame plan(const PlanBasis& basis, const PlanGoal& goal);

/// The estimate of knobs that a request names; none where they are no row.
std::optional<FrameEstimate> estimate_of(const PlanBasis& basis, const Knobs& knobs);

}  // namespace pelage
