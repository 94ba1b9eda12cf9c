// From measured frames to the defaults of the dial.
#pragma once

#include <span>
#include <vector>

#include "renderer/quality/dial_model.h"

namespace pelage::bench {

/// One view, drawn with every row.
struct MeasuredView {
  ViewFeatures features;
  std::vector<double> cost_ms;  // above 0
  std::vector<double> error;    // mean FLIP, above 0
};

/// Prices by least squares of the relative error, none below 0; errors by lines through their logarithms over that of
/// the fur's length. Safeties are such that 95% of the views keep them when the fit does not know the view; what is
/// learnt of a scene counts as the median of its rows. At least three views, each as long as `rows`.
DialModel fit(std::span<const Knobs> rows, std::span<const MeasuredView> views);

}  // namespace pelage::bench
