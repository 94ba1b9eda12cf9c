#include "protocol/commands/answers.h"

namespace pelage {

std::string to_hex(FieldsHash hash) {
  static constexpr char digits[] = "0123456789abcdef";
  std::string text(32, '0');
  for (std::size_t i = 0; i < 32; ++i) {
    const std::uint64_t half = i < 16 ? hash.high : hash.low;
    text[i] = digits[(half >> (60 - 4 * (i % 16))) & 15];
  }
  return text;
}

}  // namespace pelage
