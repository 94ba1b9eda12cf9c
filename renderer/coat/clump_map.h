// The clumps of a coat's tile as a texture: where the strands of each place gather.
#pragma once

#include <cstdint>
#include <vector>

#include "protocol/commands/coat.h"

namespace pelage {

/// `side * side` texels of 4 bytes, x fastest, over the periodic tile: the way to the middle of the place's clump over
/// +-reach (x, y), how far inside of the clump it lies (0 on the border to the next, 1 in the middle), and the clump's
/// pull (Clump).
struct ClumpMap {
  static constexpr int side = 256;
  std::vector<std::uint8_t> texels;
  double reach = 0;  // tiles
};

/// Of the clumps that `clump` and `clump_size` of the coat make. Deterministic in the coat alone.
ClumpMap bake_clump_map(const Coat& coat);

}  // namespace pelage
