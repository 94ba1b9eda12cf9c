// From a budget or an error to knobs. Pure: the same arguments give the same choice.
#pragma once

#include <functional>
#include <optional>
#include <vector>

#include "protocol/commands/quality.h"
#include "renderer/quality/view_features.h"

namespace pelage {

/// Costs of a scene over what its features predict, learnt from its frames (CostLog).
struct CostCorrection {
  double shells = 1, sorted = 1;                             // by Knobs::order
  bool shells_are_learnt = false, sorted_is_learnt = false;  // from enough frames

  double of(const Knobs& knobs) const { return knobs.order == FragmentOrder::sorted ? sorted : shells; }
  bool learnt(const Knobs& knobs) const {
    return knobs.order == FragmentOrder::sorted ? sorted_is_learnt : shells_are_learnt;
  }
  bool operator==(const CostCorrection&) const = default;
};

/// Errors of a scene over what its features predict, of the rows of a ladder that were measured in a view.
class MeasuredErrors {
 public:
  /// `error` over `predicted`, both above 0.
  void note(std::size_t row, double error, double predicted);
  bool has(std::size_t row) const { return row < ratios_.size() && ratios_[row] > 0; }
  bool empty() const { return ratios_.empty(); }
  /// That of the row, or the geometric mean of what was measured in that order of fragments, or of all; 1 for nothing.
  double ratio(std::size_t row, const Calibration& calibration) const;

 private:
  static constexpr double furthest = 16;  // from a prediction that counts: parts may be the truth itself
  std::vector<double> ratios_;            // of each row, 0 where it was not measured
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

/// The mean FLIP of knobs in the view, above 0; none where it cannot be told.
using MeasureError = std::function<std::optional<double>(const Knobs&)>;

/// A row of the ladder. budget_ms: the least safe error of those whose safe cost is within budget_margin of it, else
/// the cheapest. max_error: the cheapest of those whose safe error is at most that, else the one with the least. Of
/// equal ones the first. Rows that a request of this size could not name itself are left out. So more budget never
/// gives a larger safe error, and a larger error never a larger estimated cost.
PlannedFrame plan(const Calibration& calibration, const ViewFeatures& view, const FurFrame& frame,
                  const CostCorrection& correction, const PlanGoal& goal, const MeasuredErrors& errors = {});

/// The same for an error, of rows that were measured: as long as the cheapest row that may well keep it was not, it is.
/// Once one was, a row may well that needs a tenth less of an error than the others let expect. `errors` holds what is
/// known already and takes what is measured. By features alone where nothing can be measured.
PlannedFrame plan_measured(const Calibration& calibration, const ViewFeatures& view, const FurFrame& frame,
                           const CostCorrection& correction, double max_error, MeasuredErrors& errors,
                           const MeasureError& measure);

/// The estimate of knobs that a request names; none where they are not on the ladder.
std::optional<FrameEstimate> estimate_of(const Calibration& calibration, const ViewFeatures& view, const Knobs& knobs,
                                         const CostCorrection& correction);

/// Whether frames of this size take the knobs: the limits that requests are held to.
bool fits(const Knobs& knobs, int width, int height);

}  // namespace pelage
