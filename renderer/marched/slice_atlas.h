// The slices of a coat as the marcher reads them: all slices of a place side by side, so that a ray that goes through
// the fur stays in few lines of the cache.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "renderer/coat/slices.h"

namespace pelage {

struct SliceAtlas {
  std::vector<std::int32_t> shapes, colours;       // four bytes each, as in SliceLevel; x 0 lowest
  std::array<std::int32_t, slice_levels> first{};  // texel of each level: ((y side + x) slice_count + slice) follows
  int finest = 0;                                  // levels before it have no texels

  explicit SliceAtlas(const Slices& slices);
  std::size_t bytes() const { return 4 * (shapes.capacity() + colours.capacity()); }
};

}  // namespace pelage
