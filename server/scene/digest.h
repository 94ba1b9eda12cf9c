// A name for bytes that follows from them alone.
#pragma once

#include <string>
#include <string_view>

namespace pelage {

/// 128 bits as 32 hex digits, the same on every server. Not against people who look for two texts with one digest.
std::string digest(std::string_view bytes);

}  // namespace pelage
