// Grid cells as structures of arrays, so that loops over them are vectorized: counts are multiples of four, and there
// are no branches.
#pragma once

#include <array>
#include <cstdint>
#include <glm/glm.hpp>

namespace pelage {

template <std::size_t count>
struct Cells {
  std::array<std::uint32_t, count> x, y, z;
};

/// Three numbers in [0, 1) for each cell.
template <std::size_t count>
struct CellNumbers {
  std::array<float, count> x, y, z;
};

/// Returns the eight cells of the cube whose lowest one is `low`, x fastest.
inline Cells<8> corner_cells(glm::ivec3 low) {
  Cells<8> cells;
  for (std::uint32_t i = 0; i < 8; ++i) {
    cells.x[i] = static_cast<std::uint32_t>(low.x) + (i & 1);
    cells.y[i] = static_cast<std::uint32_t>(low.y) + (i >> 1 & 1);
    cells.z[i] = static_cast<std::uint32_t>(low.z) + (i >> 2);
  }
  return cells;
}

/// Returns random numbers by PCG3D (Jarzynski, Olano 2020): pure functions of cell, stream and seed.
template <std::size_t count>
CellNumbers<count> numbers_of(Cells<count> cells, std::uint32_t stream, std::uint32_t seed) {
  const std::uint32_t key = seed * 0x9e3779b9u + stream * 0x85ebca6bu;
  CellNumbers<count> numbers;
  for (std::size_t i = 0; i < count; ++i) {
    std::uint32_t x = (cells.x[i] + key) * 1664525u + 1013904223u;
    std::uint32_t y = (cells.y[i] + key * 0xc2b2ae35u) * 1664525u + 1013904223u;
    std::uint32_t z = (cells.z[i] + key * 0x27d4eb2fu) * 1664525u + 1013904223u;
    x += y * z, y += z * x, z += x * y;
    x ^= x >> 16, y ^= y >> 16, z ^= z >> 16;
    x += y * z, y += z * x, z += x * y;
    const auto share = [](std::uint32_t bits) { return static_cast<float>(static_cast<std::int32_t>(bits >> 8)); };
    numbers.x[i] = share(x) * 0x1p-24f, numbers.y[i] = share(y) * 0x1p-24f, numbers.z[i] = share(z) * 0x1p-24f;
  }
  return numbers;
}

}  // namespace pelage
