// The segments of strands that fall into each tile of a box, nearest first.
#pragma once

#include <span>
#include <vector>

#include "renderer/raster/kernels.h"

namespace pelage {

/// A segment in a tile.
struct BinEntry {
  std::uint32_t batch : 8, knot : 24;  // its first
  std::uint32_t key;                   // of the distance of what of it lies nearest to the tile's middle (DistanceKeys)
};

/// Segments by tile: batches are found, then put in their places, each on a thread of its own; the order does not
/// depend on it.
class Bins {
 public:
  static constexpr std::size_t max_batches = 256, max_knots = 1 << 24;

  /// Begins with nothing in a box, in memory that it has already.
  void begin(const PixelBox& box, std::size_t batches);

  /// Finds the segments of a batch that fall into tiles in front of the background: `furthest` has one over the
  /// background's distance for each tile.
  void find(std::size_t batch, const PlacedStrands& strands, std::span<const float> furthest, const DistanceKeys& keys);
  /// After all batches were found.
  void make_room();
  void put(std::size_t batch);
  /// Returns a tile's entries in the order of batches, strands and knots. Call it after all batches were put.
  std::span<const BinEntry> tile(int number) const {
    const auto at = static_cast<std::size_t>(number);
    return std::span(entries_).subspan(first_[at], first_[at + 1] - first_[at]);
  }
  /// That it keeps.
  std::size_t bytes() const;

 private:
  struct FoundEntry {
    std::uint32_t tile;
    BinEntry entry;
  };
  struct Batch {
    std::vector<FoundEntry> found;
    std::vector<std::uint32_t> next;  // by tile: a count, then where its next entry goes
  };

  PixelBox box_;
  TileRows tiles_;
  std::vector<Batch> batches_;
  std::vector<std::uint32_t> first_;  // entry of each tile
  std::vector<BinEntry> entries_;
};

/// Sorts a tile's entries by their keys, nearest first, stable. `room` is used on the way.
void sort_by_distance(std::span<const BinEntry> entries, std::vector<BinEntry>& sorted, std::vector<BinEntry>& room);

}  // namespace pelage
