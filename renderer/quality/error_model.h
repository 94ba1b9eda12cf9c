// How far a frame of shells is from many sorted ones, as far as a view tells without being drawn. Each knob set of the
// ladder has a line of its own: the logarithm of the error over traits of the view.
#pragma once

#include <array>

#include "protocol/commands/quality.h"
#include "renderer/quality/view_features.h"

namespace pelage {

/// Below this an error is not told apart from none.
inline constexpr double min_error = 1e-5;

using ErrorTraits = std::array<double, error_traits>;

/// Binary logarithms of the fur's length, the strands' width and the model's size in pixels; the share of fur behind
/// other fur; the skin's bending; the coat's lightness. Finite.
ErrorTraits error_traits_of(const ViewFeatures& view);

/// The traits from 0 to 1 over the range that was measured; what lies outside counts as its end.
ErrorTraits in_range(const Calibration& calibration, const ErrorTraits& traits);

/// Mean FLIP of an average frame like this (FrameEstimate), (0, 1].
double predicted_error(const CalibratedKnobs& row, const ErrorTraits& in_range);

}  // namespace pelage
