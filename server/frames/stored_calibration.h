// The calibration that the server plans by: one that was measured here, or the safe defaults.
#pragma once

#include <string>

#include "protocol/base/status.h"
#include "protocol/commands/quality.h"

namespace pelage {

/// defaults.json beside this file; tests/bench/dial.cpp writes it.
const Calibration& default_calibration();

/// Reads a file that write_calibration has written. Fails with not_found where there is none, and (invalid) with what
/// is wrong with it: not readable as a calibration, or measured with another GL or another number of threads.
Result<Calibration> read_calibration(const std::string& path, const std::string& machine, int threads);

/// By rename, so that readers see no half of it. Fails with internal.
Status write_calibration(const std::string& path, const Calibration& calibration);

}  // namespace pelage
