// Random numbers that are a pure function of a seed and a counter, so that every replay draws the same ones.
#pragma once

#include <cstdint>

namespace pelage {

/// SplitMix64's finaliser: a bijection of 64-bit numbers with good avalanche (Steele et al. 2014).
constexpr std::uint64_t mix_bits(std::uint64_t x) {
  x += 0x9e3779b97f4a7c15ULL;
  x = (x ^ (x >> 30)) * 0xbf58476d1ce4e5b9ULL;
  x = (x ^ (x >> 27)) * 0x94d049bb133111ebULL;
  return x ^ (x >> 31);
}

/// A stream of uniform numbers in [0, 1).
class Random {
 public:
  explicit constexpr Random(std::uint64_t seed, std::uint64_t stream = 0)
      : state_(mix_bits(seed) ^ mix_bits(~stream)) {}

  constexpr double uniform() {
    state_ += 0x9e3779b97f4a7c15ULL;
    return static_cast<double>(mix_bits(state_) >> 11) * 0x1p-53;
  }
  constexpr double uniform(double low, double high) { return low + (high - low) * uniform(); }

 private:
  std::uint64_t state_;
};

}  // namespace pelage
