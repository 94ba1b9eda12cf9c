// The author of a change, from the header Pelage-Author.
#pragma once

#include <string>
#include <string_view>

#include "base/status.h"

namespace pelage {

inline constexpr const char* author_header = "Pelage-Author";

/// Refuses (malformed) a name that is not 1 to 200 bytes of UTF-8 without control characters.
Status check_author(std::string_view name);

/// Percent-encodes a name for the header: every byte except letters, digits and "-._~" becomes %XX. Libraries that
/// decode header values, such as cpp-httplib, restore it.
std::string encoded_author(std::string_view name);

}  // namespace pelage
