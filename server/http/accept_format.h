// Which format of a picture a client wants.
#pragma once

#include <string_view>

#include "protocol/commands/frame.h"

namespace pelage {

/// Of png, jpeg and webp what the value of Accept names and likes best; of equals the first of these, and png where it
/// names none: wildcards name nothing, so that who does not ask for loss gets none.
FrameFormat accepted_format(std::string_view accept);

}  // namespace pelage
