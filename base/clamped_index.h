// Conversion of fractional numbers to indices that are clamped to a range.
#pragma once

namespace pelage {

/// Returns the whole part of `x`, clamped to [low, high]; low for NaN. A plain cast of a number that int cannot hold is
/// undefined: most machines give the lowest int, and a loop from there to the edge of a picture takes two billion
/// steps.
template <class Number>
constexpr int clamped_index(Number x, int low, int high) {
  if (!(x > static_cast<Number>(low))) return low;
  return x < static_cast<Number>(high) ? static_cast<int>(x) : high;
}

}  // namespace pelage
