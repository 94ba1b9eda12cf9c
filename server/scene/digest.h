// A content hash that serves as a name.
#pragma once

#include <string>
#include <string_view>

namespace pelage {

/// Returns a 128-bit hash as 32 hex digits. It is the same on every server and does not resist deliberate collisions.
std::string digest(std::string_view bytes);

}  // namespace pelage
