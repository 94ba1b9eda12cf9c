#include "renderer/frame/pieces.h"

#include <algorithm>
#include <cassert>

namespace pelage {

namespace {

constexpr double min_pixels = 32 * 32;            // below it a piece costs its triangles, not its pixels
constexpr double max_growth = 2, max_shrink = 8;  // from one piece to the next: dense fur may follow empty pixels

}  // namespace

Area Pieces::next() {
  assert(!done());
  Area piece = open_.back();
  open_.pop_back();
  while (piece.pixels() > std::max(max_, 1.0)) {
    const std::vector<Area> parts = halves(piece);
    open_.push_back(parts[1]);
    piece = parts[0];
  }
  last_ = piece.pixels();
  return piece;
}

void Pieces::took(double milliseconds) {
  const double fitting = last_ * target_ms / std::max(milliseconds, 1e-3);
  max_ = std::max(min_pixels, std::clamp(fitting, max_ / max_shrink, max_ * max_growth));
}

}  // namespace pelage
