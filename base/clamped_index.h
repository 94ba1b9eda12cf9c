// Conversion of fractional numbers to indices that are clamped to a range.
#pragma once

namespace pelage {

/// The whole part of `x` within [low, high], low for NaN. A plain cast of what int cannot hold is undefined: on most
/// machines it gives the lowest int, from which a loop to an edge of a picture runs for two thousand million rounds.
template <class Number>
constexpr int clamped_index(Number x, int low, int high) {
  if (!(x > static_cast<Number>(low))) return low;
  return x < static_cast<Number>(high) ? static_cast<int>(x) : high;
}

}  // namespace pelage
