#include "renderer/frame/pieces.h"

#include <algorithm>
#include <cassert>

namespace pelage {

namespace {

constexpr double min_work = 10000;  // below it the time of a piece says nothing of a unit's, unless it is long
constexpr double forgetting = 0.9;  // of the slowest unit, with each that is faster

}  // namespace

Area Pieces::next() {
  assert(!done());
  Area piece = open_.back();
  open_.pop_back();
  while (piece.pixels() >= 2 * min_pixels && work_(piece) * unit_ms_ > target_ms) {
    const std::vector<Area> parts = halves(piece);
    open_.push_back(parts[1]);
    piece = parts[0];
  }
  last_ = work_(piece);
  return piece;
}

void Pieces::took(double milliseconds) {
  const double slowest = last_ < min_work ? unit_ms_ : forgetting * unit_ms_;
  unit_ms_ = std::max(slowest, milliseconds / std::max(last_, min_work));
}

}  // namespace pelage
