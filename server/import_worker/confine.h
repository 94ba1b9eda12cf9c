// Giving up every right that parsing does not need.
#pragma once

#include <cstddef>

#include "protocol/base/status.h"

namespace pelage {

/// From here on this process may compute, read and write its three open streams, and end. Opening files, sockets, new
/// processes and threads fail with EPERM. It is ended (SIGXCPU) after `seconds` of processor time, and has at most
/// `memory_bytes` of address space (not under the sanitizers, which map terabytes). Refused (internal) when the
/// kernel does not take one of these.
Status confine(double seconds, std::size_t memory_bytes);

}  // namespace pelage
