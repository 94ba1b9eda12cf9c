// The knob sets that a calibration chooses its ladder from.
#pragma once

#include <vector>

#include "protocol/commands/frame.h"

namespace pelage {

/// Candidates, and the tiers of shells that need no maps and fins, so that their frames have an estimate too.
std::vector<Knobs> candidate_ladder();

}  // namespace pelage
