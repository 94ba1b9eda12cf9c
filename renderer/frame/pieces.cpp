#include "renderer/frame/pieces.h"

#include <algorithm>
#include <cassert>

namespace pelage {

namespace {

constexpr double least_pixels = 32 * 32;           // below it a piece costs its triangles, not its pixels
constexpr double most_growth = 2, most_shrink = 8;  // from one piece to the next: dense fur may follow empty pixels

}  // namespace

Area Pieces::next() {
  assert(!done());
  Area piece = open_.back();
  open_.pop_back();
  while (piece.pixels() > std::max(most_, 1.0)) {
    const std::vector<Area> parts = halves(piece);
    open_.push_back(parts[1]);
    piece = parts[0];
  }
  last_ = piece.pixels();
  return piece;
}

void Pieces::took(double milliseconds) {
  const double fitting = last_ * target_ms / std::max(milliseconds, 1e-3);
  most_ = std::max(least_pixels, std::clamp(fitting, most_ / most_shrink, most_ * most_growth));
}

}  // namespace pelage
