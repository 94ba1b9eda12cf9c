// What `pelaged --calibrate` does.
#pragma once

#include <string>

#include "protocol/base/status.h"
#include "renderer/gl/context/context.h"

namespace pelage {

/// Measures this machine with a progress bar on standard error, and writes the calibration, named after the day, to
/// `file`, whose folder is made where it is missing. Fails as select_context and calibrate do, and with internal when
/// the file cannot be written.
Status calibrate_machine(GlChoice gl, int threads, const std::string& file);

}  // namespace pelage
