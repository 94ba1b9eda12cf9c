// Which format of a picture a client wants.
#pragma once

#include <string_view>

#include "protocol/commands/frame.h"

namespace pelage {

/// The format among png, jpeg and webp that the value of Accept names and prefers: of equal preferences the first in
/// this order, and png if it names none. Wildcards name nothing, so that a client that does not ask for a lossy format
/// gets none.
FrameFormat accepted_format(std::string_view accept);

}  // namespace pelage
