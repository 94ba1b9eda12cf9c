// The planner keeps what it promises, whatever the calibration says.
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <cmath>
#include <set>
#include <vector>

#include "protocol/base/limits.h"
#include "renderer/quality/cost_model.h"
#include "renderer/quality/error_model.h"
#include "tests/unit/quality/views.h"

namespace pelage {
namespace {

using testing::frame_of;
using testing::Patch;
using testing::plain_calibration;

const ViewFeatures& square() {
  static const ViewFeatures view = view_features(frame_of(512, 512), Patch().skin());
  return view;
}

PlannedFrame with_budget(const Calibration& calibration, double budget, const CostCorrection& correction = {}) {
  return plan(calibration, square(), frame_of(512, 512), correction, {budget, {}});
}

PlannedFrame with_error(const Calibration& calibration, double error) {
  return plan(calibration, square(), frame_of(512, 512), {}, {{}, error});
}

double number(int low, int high, double unit) { return unit * *rc::gen::inRange(low, high); }

/// Any prices and any errors, monotone in nothing.
Calibration any_calibration() {
  Calibration calibration = plain_calibration();
  for (double& price : calibration.cost) price = number(0, 1000, 0.1);
  calibration.cost_safety = number(100, 300, 0.01);
  for (CalibratedKnobs& row : calibration.ladder) {
    row.log_error = number(-900, 100, 0.01), row.error_safety = number(100, 400, 0.01);
    row.knobs.shells = *rc::gen::inRange(1, 1025), row.knobs.steps = *rc::gen::inRange(1, 17);
    for (double& slope : row.slopes) slope = number(-300, 300, 0.01);
  }
  return calibration;
}

RC_GTEST_PROP(Planner, MoreBudgetNeverGivesALargerError, ()) {
  const Calibration calibration = any_calibration();
  const double less = number(1, 5000, 1), more = less * number(100, 1000, 0.01);
  const auto safe_error = [&](double budget) {
    const FrameEstimate e = with_budget(calibration, budget).estimate;
    return e.error * e.error_safety;
  };
  RC_ASSERT(safe_error(more) <= safe_error(less));
}

RC_GTEST_PROP(Planner, ASmallerErrorIsNeverCheaper, ()) {
  const Calibration calibration = any_calibration();
  const double large = number(1, 1000, 1e-3), small = large * number(1, 1000, 1e-3);
  RC_ASSERT(with_error(calibration, small).estimate.cost_ms >= with_error(calibration, large).estimate.cost_ms);
}

RC_GTEST_PROP(Planner, TheSameRequestHasTheSameKnobs, ()) {
  const Calibration calibration = any_calibration();
  const double budget = number(1, 600'000, 1);
  RC_ASSERT(with_budget(calibration, budget).knobs == with_budget(calibration, budget).knobs);
}

RC_GTEST_PROP(Planner, WhatItSaysIsWhatItChose, ()) {
  const Calibration calibration = any_calibration();
  const PlannedFrame planned = with_budget(calibration, number(1, 5000, 1));
  const FrameEstimate& e = planned.estimate;
  RC_ASSERT(e.cost_ms == predicted_cost(calibration, square(), planned.knobs));
  RC_ASSERT(e.error > 0 && e.error <= 1 && std::isfinite(e.cost_ms));
}

/// What is measured is `factor` times what is predicted, but for rows whose number `odd` divides: those are twice as
/// far off.
MeasureError off_by(const Calibration& calibration, double factor, std::size_t odd, std::vector<std::size_t>& asked) {
  return [&calibration, factor, odd, &asked](const Knobs& knobs) -> std::optional<double> {
    std::size_t row = 0;
    while (!(calibration.ladder[row].knobs == knobs)) ++row;
    asked.push_back(row);
    const double predicted = predicted_error(calibration.ladder[row], in_range(calibration, error_traits_of(square())));
    return predicted * factor * (row % odd == 0 ? 2 : 1);
  };
}

RC_GTEST_PROP(Planner, WhatWasMeasuredKeepsTheErrorAndNothingCheaperIsExpectedTo, ()) {
  Calibration calibration = any_calibration();
  calibration.probe_safety = number(100, 200, 0.01);
  for (std::size_t i = 0; i < calibration.ladder.size(); ++i)
    calibration.ladder[i].knobs.steps = static_cast<int>(i) + 1;
  const double max = number(1, 1000, 1e-3), factor = number(10, 500, 0.01);
  std::vector<std::size_t> asked;
  MeasuredErrors errors;
  const MeasureError measure = off_by(calibration, factor, 3, asked);
  const PlannedFrame planned = plan_measured(calibration, square(), frame_of(512, 512), {}, max, errors, measure);
  const FrameEstimate& e = planned.estimate;
  RC_ASSERT(e.measured && e.error_safety == calibration.probe_safety);
  const double told = std::min(1.0, *off_by(calibration, factor, 3, asked)(planned.knobs));
  asked.pop_back();
  RC_ASSERT(std::abs(e.error - told) <= 1e-9 * told);                      // what was measured of it, not of others
  RC_ASSERT(std::set(asked.begin(), asked.end()).size() == asked.size());  // nothing is measured twice
  if (e.end == PlanEnd::error) RC_ASSERT(e.error * e.error_safety <= max);
  asked.clear();
  RC_ASSERT(plan_measured(calibration, square(), frame_of(512, 512), {}, max, errors, measure).knobs == planned.knobs);
  RC_ASSERT(asked.empty());  // the same request asks for nothing more
  const PlannedFrame again = plan(calibration, square(), frame_of(512, 512), {}, {{}, max}, errors);
  RC_ASSERT(again.knobs == planned.knobs);
}

/// The cheapest row that is near enough, though the others let expect a bit more than that of it.
TEST(Planner, ARowThatMayBeNearEnoughIsMeasured) {
  const Calibration calibration = plain_calibration();
  const auto predicted = [&](const Knobs& knobs) { return estimate_of(calibration, square(), knobs, {})->error; };
  const Knobs lucky = with_error(calibration, 0.3).knobs;
  const auto chosen = [&](double max) {
    MeasuredErrors errors;
    const MeasureError measure = [&](const Knobs& knobs) { return predicted(knobs) * (knobs == lucky ? 0.92 : 1); };
    return plan_measured(calibration, square(), frame_of(512, 512), {}, max, errors, measure);
  };
  EXPECT_EQ(chosen(predicted(lucky) * 0.93).knobs, lucky);
  EXPECT_EQ(chosen(predicted(lucky) * 0.93).estimate.error_safety, calibration.probe_safety);
  EXPECT_FALSE(chosen(predicted(lucky) * 0.91).knobs == lucky);
}

TEST(Planner, WithoutAMeasurementErrorsAreEstimatedFromTheView) {
  const Calibration calibration = plain_calibration();
  MeasuredErrors errors;
  const MeasureError nothing = [](const Knobs&) { return std::optional<double>(); };
  const PlannedFrame planned = plan_measured(calibration, square(), frame_of(512, 512), {}, 0.05, errors, nothing);
  EXPECT_EQ(planned.knobs, with_error(calibration, 0.05).knobs);
  EXPECT_FALSE(planned.estimate.measured);
}

TEST(ErrorLog, KeepsWhatWasMeasuredForLikeViewsOfAScene) {
  ErrorLog log;
  FurFrame frame = frame_of(512, 512);
  frame.model = 7;
  log.of(frame, {}).note(2, 0.1, 0.2);
  EXPECT_TRUE(log.of(frame, {0.1}).has(2));
  FurFrame other = frame;
  other.model = 8;
  EXPECT_FALSE(log.of(other, {}).has(2));
  EXPECT_TRUE(log.of(frame, {}).has(2));
  EXPECT_FALSE(log.of(frame, {0.3}).has(2)) << "seen from elsewhere";
  log.of(frame, {0.3}).note(2, 0.1, 0.2);
  frame.coat.count = 1234;
  EXPECT_FALSE(log.of(frame, {0.3}).has(2)) << "another coat";
}

TEST(Planner, TheEndSaysWhy) {
  const Calibration calibration = plain_calibration();
  EXPECT_EQ(with_budget(calibration, 600'000).estimate.end, PlanEnd::best);
  EXPECT_EQ(with_budget(calibration, 600'000).knobs.order, FragmentOrder::sorted);
  EXPECT_EQ(with_budget(calibration, 600'000).knobs.shells, 64);
  EXPECT_EQ(with_error(calibration, 1).estimate.end, PlanEnd::error);
  EXPECT_EQ(with_error(calibration, 1).knobs.shells, 4);
  EXPECT_EQ(with_error(calibration, 1e-6).estimate.end, PlanEnd::best);
  const double min = with_error(calibration, 1).estimate.cost_ms;
  EXPECT_EQ(with_budget(calibration, min * 0.9).estimate.end, PlanEnd::cheapest);
  EXPECT_EQ(with_budget(calibration, min * 2).estimate.end, PlanEnd::budget);
  EXPECT_EQ(with_budget(calibration, 100).estimate.calibration, "by hand");
}

TEST(Planner, BetweenEqualErrorsABudgetTakesTheSurerOne) {
  Calibration calibration = plain_calibration();
  calibration.cost.fill(0), calibration.cost[0] = 1;  // all cost the same
  for (CalibratedKnobs& row : calibration.ladder) row.log_error = -3, row.slopes.fill(0), row.error_safety = 2;
  calibration.ladder[6].error_safety = 1.5;
  EXPECT_EQ(with_budget(calibration, 10).knobs, calibration.ladder[6].knobs);
}

TEST(Planner, SafetyIsKept) {
  Calibration calibration = plain_calibration();
  for (double budget = 5; budget < 500; budget *= 1.1) {
    const FrameEstimate e = with_budget(calibration, budget).estimate;
    if (e.end != PlanEnd::cheapest) {
      EXPECT_LE(e.cost_ms * e.cost_safety, budget * budget_margin);
    }
  }
  for (double error = 0.5; error > 0.05; error /= 1.1) {
    const FrameEstimate e = with_error(calibration, error).estimate;
    if (e.end == PlanEnd::error) {
      EXPECT_LE(e.error * e.error_safety, error);
    }
  }
}

TEST(Planner, ACorrectionCountsForItsOrder) {
  const Calibration calibration = plain_calibration();
  const PlannedFrame plain = with_budget(calibration, 50), dear = with_budget(calibration, 50, {4, 4});
  EXPECT_LT(dear.knobs.shells, plain.knobs.shells);
  EXPECT_EQ(dear.estimate.correction, 4);
  EXPECT_EQ(with_budget(calibration, 600'000, {1, 3}).estimate.correction, 3);
  EXPECT_EQ(with_budget(calibration, 600'000, {3, 1}).estimate.correction, 1);
}

TEST(Planner, WhatIsTooLargeToSortIsLeftOut) {
  const Calibration calibration = plain_calibration();
  const FurFrame frame = frame_of(8192, 8192);
  const ViewFeatures view = view_features(frame, Patch().skin());
  const PlannedFrame planned = plan(calibration, view, frame, {}, {600'000.0, {}});
  EXPECT_TRUE(fits(planned.knobs, 8192, 8192));
  EXPECT_FALSE(planned.knobs.order == FragmentOrder::sorted && planned.knobs.shells > 16);
  Knobs twice;
  twice.scale = 2;
  EXPECT_FALSE(fits(twice, 8192, 8));
  EXPECT_TRUE(fits(twice, 4096, 4096));
}

TEST(Planner, KnobsOfTheLadderAreEstimated) {
  const Calibration calibration = plain_calibration();
  const auto known = estimate_of(calibration, square(), calibration.ladder[3].knobs, {});
  ASSERT_TRUE(known);
  EXPECT_EQ(known->end, PlanEnd::asked);
  Knobs other = calibration.ladder[3].knobs;
  other.fins = true;
  EXPECT_FALSE(estimate_of(calibration, square(), other, {}));
}

TEST(Planner, ExtremesAreFinite) {
  const Calibration calibration = plain_calibration();
  const Patch patch, bald(8, 0.25f, 0.0f);
  for (const FurredSkin& skin : {patch.skin(), bald.skin(), FurredSkin{}}) {
    for (const auto& [width, height] : {std::pair{1, 1}, {8192, 8192}}) {
      const FurFrame frame = frame_of(width, height);
      for (const PlanGoal& goal : {PlanGoal{1.0, {}}, {600'000.0, {}}, {{}, 1e-6}, {{}, 1.0}}) {
        const FrameEstimate e = plan(calibration, view_features(frame, skin), frame, {}, goal).estimate;
        EXPECT_TRUE(std::isfinite(e.cost_ms) && e.cost_ms > 0);
        EXPECT_TRUE(e.error > 0 && e.error <= 1);
      }
    }
  }
}

}  // namespace
}  // namespace pelage
