#include "protocol/json/author.h"

#include <cctype>
#include <cstring>

#include "base/limits.h"
#include "protocol/json/reader.h"

namespace pelage {

Status check_author(std::string_view name) {
  const bool good = !name.empty() && name.size() <= limits::name_bytes && !has_control_character(name) && is_utf8(name);
  if (good) return {};
  return failure(Code::malformed, std::string(author_header) + " is no name of an author.", "",
                 "percent-encoded UTF-8, 1 to 200 bytes without control characters");
}

std::string encoded_author(std::string_view name) {
  static constexpr char digits[] = "0123456789ABCDEF";
  std::string encoded;
  for (const char c : name) {
    const auto byte = static_cast<unsigned char>(c);
    const bool plain = byte < 0x80 && (std::isalnum(byte) || (c != '\0' && std::strchr("-._~", c)));
    encoded += plain ? std::string(1, c) : std::string{'%', digits[byte >> 4], digits[byte & 15]};
  }
  return encoded;
}

}  // namespace pelage
