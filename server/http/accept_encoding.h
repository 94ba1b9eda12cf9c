// Chooses the content coding (brotli, gzip or none) that a client prefers.
#pragma once

#include <optional>
#include <string_view>

namespace pelage {

enum class ContentCoding { identity, gzip, brotli };

/// Returns the value for Content-Encoding; "" for identity.
std::string_view name_of(ContentCoding encoding);

/// Returns the coding that the value of Accept-Encoding prefers (RFC 9110 12.5.3); on ties brotli, then gzip. identity
/// is the fallback, unless the client refuses it with q=0; then the result may be none. Pass "" for an absent header.
/// Malformed items are ignored.
std::optional<ContentCoding> choose_encoding(std::string_view accepted, bool has_gzip, bool has_brotli);

}  // namespace pelage
