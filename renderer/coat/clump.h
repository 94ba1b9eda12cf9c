// Clumps scattered over the periodic tile, one to a cell of a grid: tufts, the locks inside them, and lodged patches.
#pragma once

#include <cstdint>
#include <glm/glm.hpp>
#include <vector>

#include "protocol/commands/coat.h"

namespace pelage {

/// What the strands of one clump share.
struct StrandClump {
  glm::dvec2 centre{0};              // sizes
  glm::dvec2 bow{0};                 // within the unit disc
  double length = 1, lightness = 1;  // [-1, 1]
  double pull = 1;                   // [.25, 1]: clumps are not all alike
};

/// The nearest clump, and the distances to it and to the next.
struct NearestClumps {
  StrandClump first;
  double to_first = 0, to_second = 0;  // sizes
};

class ClumpGrid {
 public:
  /// Clumps about `size` apart on a tile of side `tile`, both in sizes. Deterministic in all four.
  ClumpGrid(double tile, double size, std::uint64_t seed, std::uint64_t stream);

  /// The nearest clump on the periodic tile, its centre moved by whole tiles to lie next to `place`.
  StrandClump nearest(glm::dvec2 place) const { return nearest_two(place).first; }
  NearestClumps nearest_two(glm::dvec2 place) const;

 private:
  int wrap(int i) const { return (i % side_ + side_) % side_; }

  double tile_;
  int side_;  // cells
  std::vector<StrandClump> clumps_;
};

// The clumps of a coat's tile as a texture: where the strands of each place gather.

/// `side * side` texels of 4 bytes, x fastest, over the periodic tile: the way to the middle of the place's clump over
/// +-reach (x, y), how far inside of the clump it lies (0 on the border to the next, 1 in the middle), and the clump's
/// pull (StrandClump).
struct ClumpMap {
  static constexpr int side = 256;
  std::vector<std::uint8_t> texels;
  double reach = 0;  // tiles
};

/// Of the clumps that `clump` and `clump_size` of the coat make. Deterministic in the coat alone.
ClumpMap bake_clump_map(const Coat& coat);

}  // namespace pelage
