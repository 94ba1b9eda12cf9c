// One light through the cells of a grid.
#pragma once

#include <array>
#include <cstdint>
#include <glm/glm.hpp>
#include <span>
#include <vector>

#include "renderer/input/fur_scene.h"

namespace pelage {

/// Where cells lie: cell c is the cube about low + (c + .5) cell.
struct GridPlace {
  glm::vec3 low{0};
  float cell = 1;      // sizes
  glm::ivec3 size{2};  // cells along each axis, at least 2

  std::size_t count() const {
    return static_cast<std::size_t>(size.x) * static_cast<std::size_t>(size.y) * static_cast<std::size_t>(size.z);
  }
  std::size_t index(glm::ivec3 c) const {
    const auto x = static_cast<std::size_t>(c.x), y = static_cast<std::size_t>(c.y), z = static_cast<std::size_t>(c.z);
    return (z * static_cast<std::size_t>(size.y) + y) * static_cast<std::size_t>(size.x) + x;
  }
  bool has(glm::ivec3 c) const {
    return !glm::any(glm::lessThan(c, glm::ivec3(0))) && !glm::any(glm::greaterThanEqual(c, size));
  }
  bool operator==(const GridPlace&) const = default;
};

/// Of a cell's face what strands across it cover, and that times their direction, in fixed point: sums do not depend on
/// their order.
struct CellDensity {
  static constexpr float one = 65536;
  std::array<std::int64_t, 4> sum{};
};

/// What lies between a cell's middle and a light.
struct Crossed {
  float strands = 0;  // that the light crosses on average
  float body = 0;     // optical depth of the skin
};

/// For each cell.
std::vector<Crossed> light_cells(const GridPlace& place, std::span<const CellDensity> density, const FurModel& model,
                                 const FurLight& light);

}  // namespace pelage
