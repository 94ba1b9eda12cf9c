// Percent encoding and decoding of URLs (RFC 3986).
#pragma once

#include <string>
#include <string_view>

namespace pelage {

/// Encodes a value for a URL: every byte except letters, digits and the characters "-._~," becomes %XX.
std::string percent_encoded(std::string_view text);

/// Replaces each %XX by its byte; anything else stays as it is.
std::string percent_decoded(std::string_view text);

}  // namespace pelage
