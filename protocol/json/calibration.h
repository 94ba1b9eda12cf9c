// A machine's calibration as a JSON document: what `pelaged --calibrate` writes and `pelaged` reads.
#pragma once

#include <string>
#include <string_view>

#include "base/status.h"
#include "protocol/commands/quality.h"

namespace pelage {

/// One line.
std::string encode(const Calibration& calibration);

/// Refused as a request is, with a pointer: another version, unknown members, numbers that are out of range.
Result<Calibration> decode_calibration(std::string_view text);

}  // namespace pelage
