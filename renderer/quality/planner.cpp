#include "renderer/quality/planner.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <vector>

#include "protocol/base/limits.h"
#include "renderer/quality/cost_model.h"
#include "renderer/quality/error_model.h"

namespace pelage {

namespace {

/// Of a row that was not measured in a view where others were: it is worth measuring where it may be so much nearer to
/// the truth than they let expect.
constexpr double hope = 0.9;

/// A row of the ladder in this view.
struct Option {
  const CalibratedKnobs* row = nullptr;
  FrameEstimate estimate;

  double safe_cost() const { return estimate.cost_ms * estimate.cost_safety; }
  double safe_error() const { return estimate.error * estimate.error_safety; }
  bool keeps(double max_error) const { return std::min(1.0, safe_error()) <= max_error; }  // no FLIP is above 1
};

/// Once anything was measured, the others are expected to be as far from their prediction.
FrameEstimate estimate(const Calibration& calibration, const CalibratedKnobs& row, const ViewFeatures& view,
                       const CostCorrection& correction, const MeasuredErrors& errors = {}) {
  const double factor = correction.of(row.knobs);
  const auto index = static_cast<std::size_t>(&row - calibration.ladder.data());
  const double error = predicted_error(row, in_range(calibration, error_traits_of(view)));
  return {.error = std::min(1.0, error * errors.ratio(index, calibration)),
          .error_safety = errors.empty()      ? row.error_safety
                          : errors.has(index) ? calibration.probe_safety
                                              : hope,
          .measured = errors.has(index),
          .cost_ms = predicted_cost(calibration, view, row.knobs) * factor,
          .cost_safety = correction.learnt(row.knobs) ? calibration.learnt_safety : calibration.cost_safety,
          .correction = factor,
          .end = PlanEnd::asked,
          .calibration = calibration.name};
}

/// The option that is least by `measure` among those that pass; null when none does. Of equal ones the first.
template <class Measure, class Pass>
const Option* cheapest_by(const std::vector<Option>& options, Measure measure, Pass pass) {
  const Option* best = nullptr;
  for (const Option& option : options) {
    if (pass(option) && (!best || measure(option) < measure(*best))) best = &option;
  }
  return best;
}

std::size_t row_of(const Calibration& calibration, const Knobs& knobs) {
  const auto found = std::find_if(calibration.ladder.begin(), calibration.ladder.end(),
                                  [&](const CalibratedKnobs& row) { return row.knobs == knobs; });
  assert(found != calibration.ladder.end());
  return static_cast<std::size_t>(found - calibration.ladder.begin());
}

const auto any = [](const Option&) { return true; };

PlannedFrame chosen(const Option& option, PlanEnd end) {
  PlannedFrame planned{option.row->knobs, option.estimate};
  planned.estimate.end = end;
  return planned;
}

PlannedFrame within_budget(const std::vector<Option>& options, double budget) {
  const auto error = [](const Option& o) { return o.safe_error(); };
  const auto cost = [](const Option& o) { return o.estimate.cost_ms; };
  const Option* best = cheapest_by(options, error, any);
  const Option* affordable =
      cheapest_by(options, error, [&](const Option& o) { return o.safe_cost() <= budget * budget_margin; });
  if (!affordable) return chosen(*cheapest_by(options, cost, any), PlanEnd::cheapest);
  return chosen(*affordable, error(*affordable) > error(*best) ? PlanEnd::budget : PlanEnd::best);
}

PlannedFrame within_error(const std::vector<Option>& options, double max_error) {
  const auto cost = [](const Option& o) { return o.estimate.cost_ms; };
  const auto error = [](const Option& o) { return o.safe_error(); };
  const Option* enough = cheapest_by(options, cost, [&](const Option& o) { return o.keeps(max_error); });
  return enough ? chosen(*enough, PlanEnd::error) : chosen(*cheapest_by(options, error, any), PlanEnd::best);
}

}  // namespace

void MeasuredErrors::note(std::size_t row, double error, double predicted) {
  assert(error > 0 && predicted > 0);
  ratios_.resize(std::max(ratios_.size(), row + 1));
  ratios_[row] = std::clamp(error / predicted, 1 / furthest, furthest);
}

double MeasuredErrors::ratio(std::size_t row, const Calibration& calibration) const {
  if (has(row)) return ratios_[row];
  double same = 0, all = 0;
  int same_count = 0, count = 0;
  for (std::size_t i = 0; i < ratios_.size(); ++i) {
    if (!has(i)) continue;
    all += std::log(ratios_[i]), ++count;
    if (calibration.ladder[i].knobs.order == calibration.ladder[row].knobs.order)
      same += std::log(ratios_[i]), ++same_count;
  }
  if (same_count) return std::exp(same / same_count);
  return count ? std::exp(all / count) : 1;
}

bool fits(const Knobs& knobs, int width, int height) {
  const double drawn_width = width * knobs.scale, drawn_height = height * knobs.scale;
  if (std::max(drawn_width, drawn_height) > limits::frame_pixels) return false;
  const bool sorted = knobs.order == FragmentOrder::sorted;
  return !sorted || drawn_width * drawn_height * knobs.shells <= static_cast<double>(limits::sorted_fragments);
}

PlannedFrame plan(const Calibration& calibration, const ViewFeatures& view, const FurFrame& frame,
                  const CostCorrection& correction, const PlanGoal& goal, const MeasuredErrors& errors) {
  assert(!calibration.ladder.empty() && goal.budget_ms.has_value() != goal.max_error.has_value());
  std::vector<Option> options;
  for (const CalibratedKnobs& row : calibration.ladder) {
    if (fits(row.knobs, frame.width, frame.height))
      options.push_back({&row, estimate(calibration, row, view, correction, errors)});
  }
  if (options.empty())
    options.push_back(
        {&calibration.ladder.front(), estimate(calibration, calibration.ladder.front(), view, correction)});
  return goal.budget_ms ? within_budget(options, *goal.budget_ms) : within_error(options, *goal.max_error);
}

PlannedFrame plan_measured(const Calibration& calibration, const ViewFeatures& view, const FurFrame& frame,
                           const CostCorrection& correction, double max_error, MeasuredErrors& errors,
                           const MeasureError& measure) {
  for (std::size_t tried = 0; tried < calibration.ladder.size(); ++tried) {
    const PlannedFrame planned = plan(calibration, view, frame, correction, {{}, max_error}, errors);
    if (planned.estimate.measured) return planned;
    const std::size_t row = row_of(calibration, planned.knobs);
    const std::optional<double> error = measure(planned.knobs);
    if (!error || !(*error > 0)) return plan(calibration, view, frame, correction, {{}, max_error});
    errors.note(row, *error, predicted_error(calibration.ladder[row], in_range(calibration, error_traits_of(view))));
  }
  return plan(calibration, view, frame, correction, {{}, max_error}, errors);
}

std::optional<FrameEstimate> estimate_of(const Calibration& calibration, const ViewFeatures& view, const Knobs& knobs,
                                         const CostCorrection& correction) {
  for (const CalibratedKnobs& row : calibration.ladder) {
    if (row.knobs == knobs) return estimate(calibration, row, view, correction);
  }
  return {};
}

}  // namespace pelage
