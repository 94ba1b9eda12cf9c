// Chooses the picture format that a client prefers.
#pragma once

#include <string_view>

#include "protocol/commands/frame.h"

namespace pelage {

/// Returns the format among png, jpeg and webp that the value of Accept prefers: on ties the first in this order, and
/// png if it names none. Wildcards are ignored, so that only a client that asks for a lossy format gets one.
FrameFormat accepted_format(std::string_view accept);

}  // namespace pelage
