// Calibration: what frames cost on this machine, and the program that measures it.
#pragma once

#include <string>

#include "base/status.h"
#include "renderer/frame/renderer.h"
#include "renderer/gl/context/context.h"

namespace pelage {

/// Draws a view of each of the calibration's scenes with some rows of the dial: the median of what they cost over the
/// default prices (Calibration::price). Takes seconds. Fails as Renderer::draw.
Result<double> measure_price(Renderer& renderer);

/// What `pelaged --calibrate` does: measures this machine and writes the calibration, named after the day, to `file`,
/// whose folder is made where it is missing. Fails as select_context and measure_price do, and with internal when the
/// file cannot be written.
Status calibrate_machine(GlChoice gl, int threads, const std::string& file);

}  // namespace pelage
