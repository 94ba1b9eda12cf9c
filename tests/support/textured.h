// Models with texture coordinates, and a picture to lay on them.
#pragma once

#include <algorithm>
#include <limits>

#include "server/surface/mesh.h"

namespace pelage::testing {

/// Adds texture coordinates by the position in the bounding box seen from +z: u to the right, v up.
inline RawModel with_planar_uvs(RawModel raw) {
  glm::dvec3 low(std::numeric_limits<double>::max()), high(-low);
  for (const glm::dvec3& p : raw.positions) low = glm::min(low, p), high = glm::max(high, p);
  raw.corner_uv.clear();
  for (const std::uint32_t corner : raw.corners) {
    raw.corner_uv.emplace_back((raw.positions[corner] - low) / glm::max(high - low, 1e-9));
  }
  return raw;
}

/// Two pixels side by side: red, then blue.
inline RawImage red_and_blue() { return {2, 1, {255, 0, 0, 255, 0, 0, 255, 255}}; }

}  // namespace pelage::testing
