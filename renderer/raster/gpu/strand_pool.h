// Strands as they have grown, on the GPU: sent where a part is another.
#pragma once

#include <cstdint>
#include <memory>
#include <span>
#include <vector>

#include "renderer/raster/gpu/storage.h"
#include "renderer/strands/grown_fur.h"

namespace pelage {

/// Where a part's strands lie: renderer/raster/gpu/pools.glsl.
struct PooledStrands {
  std::uint32_t points = 0, words = 0;  // the first of each
};

class StrandPool {
 public:
  explicit StrandPool(const Gl& gl) : points_(gl), words_(gl) {}

  /// Sends the parts that have changed. Returns whether there were any.
  bool update(std::span<const GrownPart> parts);
  /// Of that number.
  PooledStrands at(std::size_t part) const { return places_[part].at; }
  const Storage& points() const { return points_; }
  const Storage& words() const { return words_; }
  /// Returns the bytes of the larger buffer for all of these parts.
  static std::size_t bytes_for(std::span<const GrownPart> parts);

 private:
  struct Place {
    std::weak_ptr<const StrandSet> strands;  // that are there
    PooledStrands at;
    std::size_t point_room = 0, word_room = 0;
  };

  /// Gives each part a place of its own, with some room to grow.
  void divide(std::span<const GrownPart> parts);
  void send(const GrownPart& part, Place& place);

  Storage points_, words_;
  std::vector<Place> places_;
};

}  // namespace pelage
