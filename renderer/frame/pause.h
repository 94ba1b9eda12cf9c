// Long drawings let others in.
#pragma once

#include <functional>

#include "protocol/base/status.h"

namespace pelage {

/// Asked between two boxes of a drawing. It may draw other frames with the same renderer meanwhile; false gives the
/// drawing up. The drawing's model has to be as it was when it answers true.
using Pause = std::function<bool()>;

inline Status drawing_given_up() { return failure(Code::conflict, "the drawing was given up"); }
inline Status no_memory_for_frame() { return failure(Code::too_large, "no memory for a frame of this size", "/width"); }

}  // namespace pelage
