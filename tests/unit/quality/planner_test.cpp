// The planner keeps its promises for any model.
#include "renderer/quality/planner.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <cmath>

namespace pelage {
namespace {

const Calibration machine{"by hand", "", 0, 2};
const ViewFeatures view{.pixels = 3e5, .area = 1e5, .fur_pixels = 12, .lights = 3, .strands = 1e5};

double number(int low, int high, double unit) { return unit * *rc::gen::inRange(low, high); }

/// A model with random coefficients and errors, monotonic in nothing.
DialModel any_model() {
  DialModel model = default_model();
  for (double& coefficient : model.coefficients) coefficient = number(0, 1000, 0.1);
  model.cost_safety = number(100, 300, 0.01);
  for (DialRow& row : model.rows) {
    row.error = std::exp(number(-900, 100, 0.01)), row.growth = number(-100, 100, 0.01);
    row.safety = number(100, 400, 0.01);
    row.knobs.raster = {number(1, 100'000, 0.01), *rc::gen::inRange(1, 9)};
  }
  return model;
}

RC_GTEST_PROP(Planner, MoreBudgetNeverGivesALargerError, ()) {
  const DialModel model = any_model();
  const double less = number(1, 5000, 1), more = less * number(100, 1000, 0.01);
  const auto safe_error = [&](double budget) {
    const FrameEstimate e = plan({model, machine, view}, {budget, {}}).estimate;
    return std::min(1.0, e.error * e.error_safety);
  };
  RC_ASSERT(safe_error(more) <= safe_error(less));
}

RC_GTEST_PROP(Planner, ASmallerErrorIsNeverCheaper, ()) {
  const DialModel model = any_model();
  const double large = number(1, 1000, 1e-3), small = large * number(1, 1000, 1e-3);
  const auto cost = [&](double error) { return plan({model, machine, view}, {{}, error}).estimate.cost_ms; };
  RC_ASSERT(cost(small) >= cost(large));
}

RC_GTEST_PROP(Planner, TheSameRequestHasTheSameKnobs, ()) {
  const DialModel model = any_model();
  const double budget = number(1, 600'000, 1);
  RC_ASSERT(plan({model, machine, view}, {budget, {}}).knobs == plan({model, machine, view}, {budget, {}}).knobs);
}

RC_GTEST_PROP(Planner, SafetyIsMetWherePossible, ()) {
  const DialModel model = any_model();
  const double budget = number(1, 5000, 1), error = number(1, 1000, 1e-3);
  const FrameEstimate in_time = plan({model, machine, view}, {budget, {}}).estimate,
                      near = plan({model, machine, view}, {{}, error}).estimate;
  if (in_time.end != PlanEnd::cheapest) RC_ASSERT(in_time.cost_ms * in_time.cost_safety <= budget * budget_margin);
  if (near.end == PlanEnd::error) RC_ASSERT(std::min(1.0, near.error * near.error_safety) <= error);
}

RC_GTEST_PROP(Planner, WhatItSaysIsWhatItChose, ()) {
  const DialModel model = any_model();
  const PlannedFrame planned = plan({model, machine, view, {3, true}}, {number(1, 5000, 1), {}});
  const auto same = [&](const DialRow& row) { return row.knobs == planned.knobs; };
  RC_PRE(std::count_if(model.rows.begin(), model.rows.end(), same) == 1);  // rows with equal knobs have two estimates
  FrameEstimate e = planned.estimate;
  e.end = PlanEnd::asked;
  RC_ASSERT(e == estimate_of({model, machine, view, {3, true}}, planned.knobs));
  RC_ASSERT(e.cost_ms == predicted_cost(model, view, planned.knobs) * 2 * 3);
  RC_ASSERT(e.cost_safety == model.learnt_safety && e.correction == 3);
}

TEST(Planner, ReportsWhyItChose) {
  const PlanBasis basis{default_model(), machine, view};
  const auto end = [&](const PlanGoal& goal) { return plan(basis, goal).estimate.end; };
  EXPECT_EQ(end({600'000.0, {}}), PlanEnd::best);
  EXPECT_EQ(end({{}, 1.0}), PlanEnd::error);
  EXPECT_EQ(end({{}, 1e-6}), PlanEnd::best);
  const FrameEstimate cheapest = plan(basis, {{}, 1.0}).estimate;
  EXPECT_EQ(end({cheapest.cost_ms * 0.5, {}}), PlanEnd::cheapest);
  EXPECT_EQ(end({cheapest.cost_ms * 4, {}}), PlanEnd::budget);
  EXPECT_EQ(cheapest.calibration, "by hand");
}

TEST(Planner, TheTierInteractiveHasAnEstimate) {
  const PlanBasis basis{default_model(), machine, view};
  EXPECT_TRUE(estimate_of(basis, knobs_of(Tier::interactive)));
  Knobs other = knobs_of(Tier::interactive);
  other.eye_steps = 1;
  EXPECT_FALSE(estimate_of(basis, other));
}

TEST(DialModel, ExtremesAreFinite) {
  const ViewFeatures nothing, most{.pixels = 7e7, .area = 1e9, .fur_pixels = 1e6, .lights = 8, .strands = 1e12};
  for (const ViewFeatures& seen : {nothing, most}) {
    for (const PlanGoal& goal : {PlanGoal{1.0, {}}, {600'000.0, {}}, {{}, 1e-6}, {{}, 1.0}}) {
      const FrameEstimate e = plan({default_model(), machine, seen}, goal).estimate;
      EXPECT_TRUE(std::isfinite(e.cost_ms) && e.cost_ms > 0);
      EXPECT_TRUE(e.error > 0 && e.error <= 1);
    }
  }
}

}  // namespace
}  // namespace pelage
