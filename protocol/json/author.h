// Who makes a change, as the header Pelage-Author names them.
#pragma once

#include <string>
#include <string_view>

#include "base/status.h"

namespace pelage {

inline constexpr const char* author_header = "Pelage-Author";

/// Refuses (malformed) a name that is not 1 to 200 bytes of UTF-8 without control characters.
Status check_author(std::string_view name);

/// The name as the header carries it: all but letters, digits and "-._~" as %XX. A reader of HTTP headers that decodes
/// them, as cpp-httplib does, gives it back.
std::string encoded_author(std::string_view name);

}  // namespace pelage
