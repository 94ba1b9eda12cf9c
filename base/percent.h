// Percent encoding and decoding of URLs (RFC 3986).
#pragma once

#include <string>
#include <string_view>

namespace pelage {

/// A value as it stands in an address: all but letters, digits and -._~, becomes %XX.
std::string percent_encoded(std::string_view text);

/// %XX becomes its byte; what is no such escape stays.
std::string percent_decoded(std::string_view text);

}  // namespace pelage
