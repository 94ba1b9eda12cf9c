// Which compressed form of a file a client wants.
#pragma once

#include <optional>
#include <string_view>

namespace pelage {

enum class ContentCoding { identity, gzip, brotli };

/// The word for Content-Encoding; "" for identity.
std::string_view name_of(ContentCoding encoding);

/// What the value of Accept-Encoding likes best (RFC 9110 12.5.3); of equals brotli, then gzip. identity is taken where
/// nothing better is there, unless it is refused with q=0; then none may be left. An absent header is "". Items that
/// cannot be read are passed over.
std::optional<ContentCoding> choose_encoding(std::string_view accepted, bool has_gzip, bool has_brotli);

}  // namespace pelage
