// What of each strand falls into each tile of a box, nearest first.
#pragma once

#include <span>
#include <vector>

#include "renderer/raster/kernels.h"

namespace pelage {

/// Tiles of a box, row by row.
struct TileRows {
  int across = 0, down = 0;
  int count() const { return across * down; }
};
inline TileRows tiles_of(const RasterBox& box) {
  return {(box.right - box.left + tile_side - 1) / tile_side, (box.bottom - box.top + tile_side - 1) / tile_side};
}

/// A segment in a tile.
struct BinEntry {
  std::uint32_t batch : 8, knot : 24;  // its first
  float inverse;                       // one over the distance of what of it lies nearest to the tile's middle
};

/// Segments by tile: batches are counted, then filled, each on a thread of its own; the order does not depend on it.
class Bins {
 public:
  static constexpr std::size_t most_batches = 256, most_knots = 1 << 24;

  Bins(const RasterBox& box, std::size_t batches);

  void count(std::size_t batch, const PlacedStrands& strands, std::span<const float> furthest);
  /// After all batches were counted.
  void make_room();
  void fill(std::size_t batch, const PlacedStrands& strands, std::span<const float> furthest);
  /// After all were filled: nearest first, of about the same distance in their order.
  std::span<const BinEntry> tile(int number) const {
    return std::span(entries_).subspan(first_[static_cast<std::size_t>(number)],
                                       first_[static_cast<std::size_t>(number) + 1] - first_[static_cast<std::size_t>(number)]);
  }
  std::size_t bytes() const { return entries_.size() * sizeof(BinEntry); }

 private:
  RasterBox box_;
  TileRows tiles_;
  std::vector<std::vector<std::uint32_t>> next_;  // of each batch, by tile: a count, then where its next entry goes
  std::vector<std::uint32_t> first_;              // entry of each tile
  std::vector<BinEntry> entries_;
};

/// Sorts a tile's entries by their distance in 1,024 steps, nearest first, stable.
void sort_by_distance(std::span<const BinEntry> entries, std::vector<BinEntry>& sorted);

}  // namespace pelage
