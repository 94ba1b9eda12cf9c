// The shares of a pattern's colours in a grid about the surface, so that a fragment reads them with one fetch.
#pragma once

#include <cstdint>
#include <glm/glm.hpp>
#include <span>
#include <vector>

#include "renderer/pattern/pattern_block.h"

namespace pelage {

struct PatternSurface {
  std::span<const glm::vec3> positions, normals;  // of vertices; internal coordinates, unit
  std::span<const glm::uvec3> triangles;
};

struct PatternVolume {
  glm::ivec3 size{1};              // cells along x, y, z; each at most 256
  glm::vec3 origin{0};             // corner of the first cell
  float cell = 1;                  // side of a cell, sizes
  std::vector<std::uint8_t> rgba;  // shares of belly, inner and marking colour; a is 255 where it was evaluated
};

/// Evaluates the pattern in the cells around the surface. A cell is .005 sizes, or more where 256 of them would not
/// do; edges of markings are that soft at least. Deterministic.
PatternVolume make_pattern_volume(const PatternBlock& block, const PatternSurface& surface);

}  // namespace pelage
