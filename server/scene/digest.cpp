#include "server/scene/digest.h"

#include <algorithm>
#include <cstring>

#include "base/random.h"
#include "protocol/commands/answers.h"

namespace pelage {

std::string digest(std::string_view bytes) {
  FieldsHash hash{bytes.size(), ~bytes.size()};
  for (std::size_t at = 0; at < bytes.size(); at += 8) {
    std::uint64_t word = 0;
    std::memcpy(&word, bytes.data() + at, std::min<std::size_t>(8, bytes.size() - at));
    hash.low = mix_bits(hash.low ^ word);
    hash.high = mix_bits(hash.high + mix_bits(~word));
  }
  return to_hex(hash);
}

}  // namespace pelage
