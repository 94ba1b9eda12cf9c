// Calibration: its knob sets, how it is measured, and the program that does it.
//
// The knob sets that a calibration chooses its ladder from.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "protocol/base/status.h"
#include "protocol/commands/frame.h"
#include "protocol/commands/quality.h"
#include "renderer/gl/context/context.h"
#include "server/calibration/measure.h"

namespace pelage {

/// The tier `interactive`, so that its frames have an estimate, and candidates that differ from it in shells, their
/// policy, steps and scale.
std::vector<Knobs> candidate_ladder();

// Measures what frames cost on this machine.

struct CalibrateOptions {
  double seconds = 60;        // no view is begun after them,
  std::size_t min_views = 4;  // but for so many
};

/// Draws the calibration's scenes with every row of the ladder of `defaults` and fits the prices anew; errors are the
/// fur's and stay. `progress` is told the share of the work that is done, [0, 1], rising to 1. Fails as Renderer::draw.
Result<Calibration> calibrate(Renderer& renderer, const CostUnit& unit, const Calibration& defaults,
                              const std::function<void(double)>& progress, const CalibrateOptions& options = {});

// What `pelaged --calibrate` does.

/// Measures this machine with a progress bar on standard error, and writes the calibration, named after the day, to
/// `file`, whose folder is made where it is missing. Fails as select_context and calibrate do, and with internal when
/// the file cannot be written.
Status calibrate_machine(GlChoice gl, int threads, const std::string& file);

}  // namespace pelage
