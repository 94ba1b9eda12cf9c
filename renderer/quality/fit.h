// From measured frames to a calibration.
#pragma once

#include <span>
#include <vector>

#include "protocol/commands/quality.h"
#include "renderer/quality/view_features.h"

namespace pelage {

/// One view, drawn with every knob set of a ladder.
struct MeasuredView {
  ViewFeatures features;
  std::vector<double> cost_ms;            // above 0
  std::vector<double> error;              // mean FLIP, [0, 1]
  std::vector<double> probed_error = {};  // the same as ErrorProbe tells it; 0 where it did not
};

/// Prices of terms by least squares of the relative error, none below 0 (coordinate descent on the normal equations);
/// errors by ridge regression of their logarithms; what a probe tells is safe by what 95% of them told. The other
/// safety factors are such that 95% of the measured views keep them when the fit does not know the view. `views` is not
/// empty, each as long as `ladder`; name, machine and threads are left to the caller; what is learnt of a scene counts
/// as the mean of its rows of one order. Deterministic.
Calibration fit_calibration(std::span<const Knobs> ladder, std::span<const MeasuredView> views);

/// The same costs alone: `errors` with the prices and the safety of cost that the views give, whose errors are not
/// looked at. Fewer than 12 views do not lower the safety.
Calibration fit_costs(const Calibration& errors, std::span<const MeasuredView> views);

/// The rows of a ladder worth keeping: those that in at least one view have less error than every cheaper row, by more
/// than the factor `slack`. In the ladder's order.
std::vector<std::size_t> pareto_rows(std::span<const MeasuredView> views, double slack = 1.02);

/// Least squares with x >= 0 for a of `columns` columns, by rows; b has as many entries as there are rows.
std::vector<double> least_squares_above_zero(std::span<const double> a, std::span<const double> b, std::size_t columns);

}  // namespace pelage
