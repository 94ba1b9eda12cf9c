// A name for bytes that follows from them alone.
#pragma once

#include <string>
#include <string_view>

namespace pelage {

/// Returns 128 bits as 32 hex digits, the same on every server. It does not protect against deliberate collisions.
std::string digest(std::string_view bytes);

}  // namespace pelage
