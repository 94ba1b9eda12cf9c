// Programs that do one action of the client.
#pragma once

#include "clients/cli/session.h"

namespace pelage {

/// Becomes the program of this name that lies beside this one, with the same arguments. Comes back only to say that it
/// cannot.
ExitCode hand_over(const char* program, char* const* arguments);

}  // namespace pelage
