// What a frame of shells costs: a sum of what is counted in it, each at a price of its own that calibration finds.
#pragma once

#include <array>

#include "protocol/commands/quality.h"
#include "renderer/quality/view_features.h"

namespace pelage {

/// Units of each term: a million pixels or fragments, a hundred thousand triangles of shells.
std::array<double, cost_terms> cost_terms_of(const ViewFeatures& view, const Knobs& knobs);

/// Milliseconds of drawing (FrameEstimate), above 0, without what eyes, curves and shadow maps add.
double predicted_cost(const Calibration& calibration, const ViewFeatures& view, const Knobs& knobs);

}  // namespace pelage
