// Lists the strand segments that fall into each tile of a box, and sorts them by distance.
#pragma once

#include <span>
#include <vector>

#include "renderer/raster/kernels.h"

namespace pelage {

/// A segment in a tile.
struct BinEntry {
  std::uint32_t batch : 8, knot : 24;  // batch of strands, and the segment's first knot in it
  std::uint32_t key;                   // DistanceKeys key of the segment's point nearest to the tile's middle
};

/// Segments grouped by tile. find() and put() may run for several batches at a time, each on its own thread; the order
/// of the entries does not depend on the threads.
class Bins {
 public:
  static constexpr std::size_t max_batches = 256, max_knots = 1 << 24;

  /// Starts an empty box. Reuses the memory that is already allocated.
  void begin(const PixelBox& box, std::size_t batches);

  /// Finds the tiles that each segment of a batch touches in front of the background. `furthest`: for each tile, 1 over
  /// the background's largest distance in it.
  void find(std::size_t batch, const PlacedStrands& strands, std::span<const float> furthest, const DistanceKeys& keys);
  /// Allocates the entries. Call it after find() of all batches and before put().
  void allocate_entries();
  void put(std::size_t batch);
  /// Returns a tile's entries in the order of batches, strands and knots. Call it after all batches were put.
  std::span<const BinEntry> tile(int number) const {
    const auto at = static_cast<std::size_t>(number);
    return std::span(entries_).subspan(first_[at], first_[at + 1] - first_[at]);
  }
  /// Returns the bytes of allocated memory.
  std::size_t bytes() const;

 private:
  struct FoundEntry {
    std::uint32_t tile;
    BinEntry entry;
  };
  struct Batch {
    std::vector<FoundEntry> found;
    std::vector<std::uint32_t> next;  // for each tile: a count, then the index of its next entry
  };

  PixelBox box_;
  TileRows tiles_;
  std::vector<Batch> batches_;
  std::vector<std::uint32_t> first_;  // index of each tile's first entry; one more at the end
  std::vector<BinEntry> entries_;
};

/// Writes a tile's entries to `sorted` by their keys, nearest first; the sort is stable. `scratch` is scratch memory.
void sort_by_distance(std::span<const BinEntry> entries, std::vector<BinEntry>& sorted, std::vector<BinEntry>& scratch);

}  // namespace pelage
