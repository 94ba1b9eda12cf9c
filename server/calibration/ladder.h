// The knob sets that a calibration chooses its ladder from.
#pragma once

#include <vector>

#include "protocol/commands/frame.h"

namespace pelage {

/// The tier `interactive`, so that its frames have an estimate, and candidates that differ from it in shells, steps,
/// scale and order.
std::vector<Knobs> candidate_ladder();

}  // namespace pelage
