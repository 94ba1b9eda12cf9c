// Calibration: measures the cost of frames on this machine and stores it.
#pragma once

#include <string>

#include "base/status.h"
#include "renderer/frame/renderer.h"
#include "renderer/gl/context/context.h"

namespace pelage {

/// Draws a view of each calibration scene with some rows of the dial. Returns the median ratio of the measured cost to
/// that of the cost model (Calibration::price). Takes seconds. Fails as Renderer::draw does.
Result<double> measure_cost_ratio(Renderer& renderer);

/// Implements `pelaged --calibrate`: measures this machine and writes the calibration, named after the day, to `file`,
/// whose folder is created if missing. Fails as select_context and measure_cost_ratio do, and with internal if the file
/// cannot be written.
Status calibrate_machine(GlChoice gl, int threads, const std::string& file);

}  // namespace pelage
