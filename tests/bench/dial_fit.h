// Fits the default model of the quality dial to measured frames.
#pragma once

#include <span>
#include <vector>

#include "renderer/quality/dial_model.h"

namespace pelage::bench {

/// Measurements of one view, one for each row of the dial.
struct MeasuredView {
  ViewFeatures features;
  std::vector<double> cost_ms;  // above 0
  std::vector<double> error;    // mean FLIP, above 0
};

/// Fits coefficients (none below 0) by least squares of the relative cost error, and each row's error as a line of
/// log(error) over log(fur length in pixels). Safety factors are such that 95% of views stay within them if the fit has
/// not seen the view; `learnt_safety` is relative to the median of a view's rows, as with a correction learnt from the
/// scene. Needs at least three views, each with a value for every row.
DialModel fit(std::span<const Knobs> rows, std::span<const MeasuredView> views);

}  // namespace pelage::bench
