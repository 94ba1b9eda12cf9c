// A level patch of fur for tests of motion.
#pragma once

#include <glm/glm.hpp>
#include <vector>

#include "server/motion/sway.h"

namespace pelage {

struct Meadow {
  std::vector<glm::vec3> positions, normals, tangents;
  std::vector<glm::vec2> direction;
  std::vector<float> length, stiffness;

  RestFur fur() const { return {positions, normals, tangents, direction, length, stiffness}; }
};

/// `side` x `side` vertices with normals up and tangents along x; fur .03 long that leans by .3 towards z.
inline Meadow make_meadow(int side = 16) {
  Meadow meadow;
  for (int i = 0; i < side * side; ++i) {
    const float x = static_cast<float>(i % side) / static_cast<float>(side) - 0.5f;
    const float z = static_cast<float>(i / side) / static_cast<float>(side) - 0.5f;
    meadow.positions.emplace_back(0.7f * x, 0.0f, 0.7f * z);
  }
  meadow.normals.assign(meadow.positions.size(), {0, 1, 0});
  meadow.tangents.assign(meadow.positions.size(), {1, 0, 0});
  meadow.direction.assign(meadow.positions.size(), {0, -0.3f});
  meadow.length.assign(meadow.positions.size(), 0.03f);
  return meadow;
}

inline double largest_change(const std::vector<glm::vec2>& a, const std::vector<glm::vec2>& b) {
  double largest = 0;
  for (std::size_t v = 0; v < a.size(); ++v) largest = std::max(largest, static_cast<double>(glm::length(a[v] - b[v])));
  return largest;
}

}  // namespace pelage
