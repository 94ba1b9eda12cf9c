// A 64-bit hash of numbers as they are in memory, to tell whether anything changed.
#pragma once

#include <cstdint>
#include <cstring>
#include <span>
#include <type_traits>

#include "protocol/base/random.h"

namespace pelage {

class Hash {
 public:
  void add(std::uint64_t word) { state_ = mix_bits(state_ ^ word); }
  void add(double value) { add_bits(value); }

  /// Values without padding between their numbers.
  template <class T>
  void add_values(std::span<const T> values) {
    static_assert(std::is_trivially_copyable_v<T> && sizeof(T) % 4 == 0);
    const auto* from = reinterpret_cast<const unsigned char*>(values.data());
    std::size_t left = values.size_bytes();
    add(static_cast<std::uint64_t>(left));
    for (; left >= 8; left -= 8, from += 8) {
      std::uint64_t word = 0;
      std::memcpy(&word, from, 8);
      add(word);
    }
    std::uint64_t rest = 0;
    std::memcpy(&rest, from, left);
    if (left > 0) add(rest);
  }
  template <class T>
  void add_value(const T& value) {
    add_values(std::span<const T>(&value, 1));
  }

  std::uint64_t value() const { return state_; }

 private:
  template <class T>
  void add_bits(T value) {
    std::uint64_t word = 0;
    std::memcpy(&word, &value, sizeof value);
    add(word);
  }

  std::uint64_t state_ = 0;
};

}  // namespace pelage
