// Small models for tests.
#pragma once

#include <cmath>
#include <initializer_list>

#include "server/surface/prepare.h"

namespace pelage::shapes {

inline RawModel model_of(std::vector<glm::dvec3> positions, std::initializer_list<std::vector<std::uint32_t>> faces) {
  RawModel raw;
  raw.positions = std::move(positions);
  for (const std::vector<std::uint32_t>& face : faces) {
    raw.face_sizes.push_back(static_cast<std::uint32_t>(face.size()));
    raw.corners.insert(raw.corners.end(), face.begin(), face.end());
  }
  return raw;
}

/// A cube of quads with corners at 0 and `side`, wound outwards.
inline RawModel cube(double side = 1, glm::dvec3 offset = glm::dvec3(0)) {
  std::vector<glm::dvec3> positions;
  for (int i = 0; i < 8; ++i) positions.push_back(offset + side * glm::dvec3(i & 1, (i >> 1) & 1, i >> 2));
  return model_of(std::move(positions),
                  {{0, 2, 3, 1}, {4, 5, 7, 6}, {0, 1, 5, 4}, {2, 6, 7, 3}, {0, 4, 6, 2}, {1, 3, 7, 5}});
}

/// A ball of triangles with `rings` rings and twice as many sectors; the poles are on Y.
inline RawModel ball(int rings) {
  RawModel raw;
  const int sectors = 2 * rings;
  const auto at = [&](int ring, int sector) {
    return ring == 0 ? 0 : ring == rings ? 1 : 2 + (ring - 1) * sectors + sector % sectors;
  };
  raw.positions = {{0, 1, 0}, {0, -1, 0}};
  for (int r = 1; r < rings; ++r) {
    for (int s = 0; s < sectors; ++s) {
      const double theta = 3.14159265358979 * r / rings, phi = 3.14159265358979 * s / rings;
      raw.positions.emplace_back(std::sin(theta) * std::cos(phi), std::cos(theta), std::sin(theta) * std::sin(phi));
    }
  }
  const auto add = [&](int a, int b, int c) {
    if (a == b || b == c || c == a) return;
    raw.face_sizes.push_back(3);
    for (int v : {a, b, c}) raw.corners.push_back(static_cast<std::uint32_t>(v));
  };
  for (int r = 0; r < rings; ++r) {
    for (int s = 0; s < sectors; ++s) {
      add(at(r, s), at(r, s + 1), at(r + 1, s));
      add(at(r, s + 1), at(r + 1, s + 1), at(r + 1, s));
    }
  }
  return raw;
}

inline Result<Mesh> prepared(const RawModel& raw, bool source_is_32_bit = false) {
  return prepare(raw, {.source_is_32_bit = source_is_32_bit});
}

}  // namespace pelage::shapes
