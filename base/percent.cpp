#include "base/percent.h"

#include <cctype>
#include <charconv>

namespace pelage {

std::string percent_encoded(std::string_view text) {
  constexpr std::string_view plain = "-._~,", digits = "0123456789ABCDEF";
  std::string result;
  for (const char c : text) {
    const auto byte = static_cast<unsigned char>(c);
    if (std::isalnum(byte) != 0 || plain.find(c) != std::string_view::npos)
      result += c;
    else
      result += {'%', digits[byte / 16], digits[byte % 16]};
  }
  return result;
}

std::string percent_decoded(std::string_view text) {
  std::string result;
  for (std::size_t i = 0; i < text.size(); ++i) {
    unsigned char byte = 0;
    const char* const two = text.data() + i + 1;
    const bool escaped =
        text[i] == '%' && i + 2 < text.size() && std::from_chars(two, two + 2, byte, 16).ptr == two + 2;
    result += escaped ? static_cast<char>(byte) : text[i];
    i += escaped ? 2 : 0;
  }
  return result;
}

}  // namespace pelage
