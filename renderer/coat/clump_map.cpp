#include "renderer/coat/clump_map.h"

#include <algorithm>
#include <cmath>

#include "renderer/coat/clump_grid.h"

namespace pelage {

namespace {

std::uint8_t byte(double value) { return static_cast<std::uint8_t>(std::lround(std::clamp(value, 0.0, 1.0) * 255)); }

}  // namespace

ClumpMap bake_clump_map(const Coat& coat) {
  const ClumpGrid clumps(coat.tile, coat.clump_size, coat.seed, 1);
  ClumpMap map;
  map.reach = std::clamp(2 * coat.clump_size / coat.tile, 1e-3, 1.0);
  map.texels.reserve(4 * ClumpMap::side * ClumpMap::side);
  for (int y = 0; y < ClumpMap::side; ++y) {
    for (int x = 0; x < ClumpMap::side; ++x) {
      const glm::dvec2 place = (glm::dvec2(x, y) + 0.5) * (coat.tile / ClumpMap::side);
      const NearestClumps near = clumps.nearest_two(place);
      const glm::dvec2 way = (near.first.centre - place) / (coat.tile * map.reach);
      const double inside = (near.to_second - near.to_first) / std::max(near.to_second + near.to_first, 1e-12);
      for (const double value : {0.5 + 0.5 * way.x, 0.5 + 0.5 * way.y, inside, near.first.pull})
        map.texels.push_back(byte(value));
    }
  }
  return map;
}

}  // namespace pelage
