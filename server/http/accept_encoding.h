// Which compressed form of a file a client wants.
#pragma once

#include <optional>
#include <string_view>

namespace pelage {

enum class ContentCoding { identity, gzip, brotli };

/// The word for Content-Encoding; "" for identity.
std::string_view name_of(ContentCoding encoding);

/// Returns the coding that the value of Accept-Encoding prefers (RFC 9110 12.5.3); among equals brotli, then gzip.
/// identity is taken where nothing better is there, unless it is refused with q=0; then there may be none left. An
/// absent header is "". Items that cannot be read are ignored.
std::optional<ContentCoding> choose_encoding(std::string_view accepted, bool has_gzip, bool has_brotli);

}  // namespace pelage
