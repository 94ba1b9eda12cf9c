#include "renderer/frame/pieces.h"

#include <algorithm>
#include <cassert>

namespace pelage {

namespace {

constexpr double min_pixels = 48 * 48;   // below it a piece costs its triangles, not its pixels
constexpr double min_fragments = 10000;  // below it the time of a piece says nothing about a fragment's
constexpr double max_growth = 2;         // from one piece to the next
constexpr double forgetting = 0.9;       // of the densest piece, with each that is less dense

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

void Pieces::took(double milliseconds, double fragments) {
  if (fragments < min_fragments) return;
  fragments_ = std::max(forgetting * fragments_, fragments / last_);
  const double fragment_ms = std::max(milliseconds, 1e-3) / fragments;
  max_ = std::clamp(target_ms / (fragments_ * fragment_ms), min_pixels, std::max(min_pixels, max_growth * max_));
}

}  // namespace pelage
