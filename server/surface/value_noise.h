// Smooth, deterministic noise in space.
#pragma once

#include <array>
#include <cstdint>
#include <glm/glm.hpp>

namespace pelage {

/// Returns value noise: random values in [-1, 1] on the integer lattice, interpolated smoothly. Requires
/// |position| < 1e9.
double value_noise(glm::dvec3 position, std::uint64_t seed);

/// Evaluates value noise at one position for several seeds.
class ValueNoise {
 public:
  explicit ValueNoise(glm::dvec3 position);
  double operator()(std::uint64_t seed) const;

 private:
  glm::i64vec3 cell_;
  std::array<double, 8> shares_;  // interpolation weights of the cell's corners
};

}  // namespace pelage
