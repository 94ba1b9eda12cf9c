// The strands of all parts on the GPU, as they have grown. Parts that have changed are sent again.
#pragma once

#include <cstdint>
#include <memory>
#include <span>
#include <vector>

#include "renderer/raster/gpu/storage.h"
#include "renderer/strands/grown_fur.h"

namespace pelage {

/// Where a part's strands lie in the pools (pools.glsl).
struct PooledStrands {
  std::uint32_t points = 0, words = 0;  // index of the first point, and of the first word
};

class StrandPool {
 public:
  explicit StrandPool(const Gl& gl) : points_(gl), words_(gl) {}

  /// Sends the parts that have changed. Returns whether any had.
  bool update(std::span<const GrownPart> parts);
  /// Returns where the strands of that part lie.
  PooledStrands at(std::size_t part) const { return ranges_[part].at; }
  const Storage& points() const { return points_; }
  const Storage& words() const { return words_; }
  /// Returns the bytes of the larger of the two buffers for these parts.
  static std::size_t bytes_for(std::span<const GrownPart> parts);

 private:
  struct Range {
    std::weak_ptr<const StrandSet> strands;  // the strands that were sent
    PooledStrands at;
    std::size_t point_capacity = 0, word_capacity = 0;
  };

  /// Assigns each part its range of the buffers, with some room to grow.
  void divide(std::span<const GrownPart> parts);
  void send(const GrownPart& part, Range& range);

  Storage points_, words_;
  std::vector<Range> ranges_;
};

}  // namespace pelage
