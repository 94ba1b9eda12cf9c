// Measures what frames cost on this machine.
#pragma once

#include <functional>

#include "protocol/commands/quality.h"
#include "server/calibration/measure.h"

namespace pelage {

struct CalibrateOptions {
  double seconds = 60;        // no view is begun after them,
  std::size_t min_views = 4;  // but for so many
};

/// Draws the calibration's scenes with every row of the ladder of `defaults` and fits the prices anew; errors are the
/// fur's and stay. `progress` is told the share of the work that is done, [0, 1], rising to 1. Fails as Renderer::draw.
Result<Calibration> calibrate(Renderer& renderer, const CostUnit& unit, const Calibration& defaults,
                              const std::function<void(double)>& progress, const CalibrateOptions& options = {});

}  // namespace pelage
