// A machine's calibration as a JSON document: what `pelaged --calibrate` writes and `pelaged` reads.
#pragma once

#include <string>
#include <string_view>

#include "base/status.h"
#include "protocol/commands/quality.h"

namespace pelage {

/// Returns one line of JSON.
std::string encode(const Calibration& calibration);

/// Refuses another version, unknown members and numbers out of range, with a pointer as for requests.
Result<Calibration> decode_calibration(std::string_view text);

}  // namespace pelage
