#include "renderer/coat/clump.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "protocol/base/random.h"

namespace pelage {

namespace {

/// `cell` and the clump's centre are counted in cells.
StrandClump make_clump(glm::dvec2 cell, double cell_side, Random& random) {
  const glm::dvec2 jitter(random.uniform(-0.2, 1.2), random.uniform(-0.2, 1.2));
  const double angle = random.uniform(0, 2 * std::numbers::pi), reach = random.uniform();
  return {(cell + jitter) * cell_side, glm::dvec2(std::cos(angle), std::sin(angle)) * reach, random.uniform(-1, 1),
          random.uniform(-1, 1), random.uniform(0.25, 1)};
}

}  // namespace

ClumpGrid::ClumpGrid(double tile, double size, std::uint64_t seed, std::uint64_t stream)
    : tile_(tile), side_(std::max(1, static_cast<int>(std::lround(tile / size)))) {
  Random random(seed, stream);
  for (int i = 0; i < side_ * side_; ++i) {
    clumps_.push_back(make_clump(glm::dvec2(i % side_, i / side_), tile_ / side_, random));
  }
}

NearestClumps ClumpGrid::nearest_two(glm::dvec2 place) const {
  const glm::ivec2 cell(glm::floor(place / tile_ * double(side_)));
  NearestClumps near{{}, 1e300, 1e300};
  for (int y = cell.y - 2; y <= cell.y + 2; ++y) {
    for (int x = cell.x - 2; x <= cell.x + 2; ++x) {
      StrandClump clump = clumps_[static_cast<std::size_t>(wrap(y) * side_ + wrap(x))];
      clump.centre += glm::dvec2(x - wrap(x), y - wrap(y)) * (tile_ / side_);
      const double distance = glm::distance(clump.centre, place);
      near.to_second = std::min(near.to_second, std::max(distance, near.to_first));
      if (distance < near.to_first) near.first = clump, near.to_first = distance;
    }
  }
  return near;
}

namespace {

std::uint8_t unorm8(double value) { return static_cast<std::uint8_t>(std::lround(std::clamp(value, 0.0, 1.0) * 255)); }

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
        map.texels.push_back(unorm8(value));
    }
  }
  return map;
}

}  // namespace pelage
