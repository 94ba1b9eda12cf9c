#include "renderer/quality/planner.h"

#include <algorithm>
#include <cassert>
#include <vector>

namespace pelage {

namespace {

double safe_cost(const PlannedFrame& option) { return option.estimate.cost_ms * option.estimate.cost_safety; }
/// Clamped, because FLIP is at most 1.
double safe_error(const PlannedFrame& option) {
  return std::min(1.0, option.estimate.error * option.estimate.error_safety);
}

FrameEstimate estimate(const PlanBasis& basis, const DialRow& row) {
  const double price = basis.machine.price * basis.correction.factor;
  return {.error = predicted_error(basis.model, row, basis.view),
          .error_safety = row.safety,
          .cost_ms = predicted_cost(basis.model, basis.view, row.knobs) * price,
          .cost_safety = basis.correction.learnt ? basis.model.learnt_safety : basis.model.cost_safety,
          .correction = basis.correction.factor,
          .end = PlanEnd::asked,
          .calibration = basis.machine.name};
}

/// Returns the option with the smallest `measure` among those that pass, the first of equal ones; null if none passes.
template <class Measure, class Pass>
const PlannedFrame* min_by(const std::vector<PlannedFrame>& options, Measure measure, Pass pass) {
  const PlannedFrame* best = nullptr;
  for (const PlannedFrame& option : options) {
    if (pass(option) && (!best || measure(option) < measure(*best))) best = &option;
  }
  return best;
}

PlannedFrame chosen(PlannedFrame option, PlanEnd end) {
  option.estimate.end = end;
  return option;
}

}  // namespace

PlannedFrame plan(const PlanBasis& basis, const PlanGoal& goal) {
  assert(!basis.model.rows.empty() && goal.budget_ms.has_value() != goal.max_error.has_value());
  std::vector<PlannedFrame> options;
  for (const DialRow& row : basis.model.rows) options.push_back({row.knobs, estimate(basis, row)});
  const auto cost = [](const PlannedFrame& o) { return o.estimate.cost_ms; };
  const auto any = [](const PlannedFrame&) { return true; };
  const PlannedFrame& nearest = *min_by(options, safe_error, any);
  if (goal.max_error) {
    const PlannedFrame* enough = min_by(options, cost, [&](const auto& o) { return safe_error(o) <= *goal.max_error; });
    return enough ? chosen(*enough, PlanEnd::error) : chosen(nearest, PlanEnd::best);
  }
  const double limit = *goal.budget_ms * budget_margin;
  const PlannedFrame* affordable = min_by(options, safe_error, [&](const auto& o) { return safe_cost(o) <= limit; });
  if (!affordable) return chosen(*min_by(options, cost, any), PlanEnd::cheapest);
  return chosen(*affordable, safe_error(*affordable) > safe_error(nearest) ? PlanEnd::budget : PlanEnd::best);
}

std::optional<FrameEstimate> estimate_of(const PlanBasis& basis, const Knobs& knobs) {
  for (const DialRow& row : basis.model.rows) {
    if (row.knobs == knobs) return estimate(basis, row);
  }
  return {};
}

}  // namespace pelage
