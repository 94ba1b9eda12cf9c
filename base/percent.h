// Percent encoding and decoding of URLs (RFC 3986).
#pragma once

#include <string>
#include <string_view>

namespace pelage {

/// Encodes a value for an address: every byte but letters, digits and -._~ becomes %XX.
std::string percent_encoded(std::string_view text);

/// Replaces each %XX by its byte; anything else stays as it is.
std::string percent_decoded(std::string_view text);

}  // namespace pelage
