// Smooth noise in space, the same for every run.
#pragma once

#include <array>
#include <cstdint>
#include <glm/glm.hpp>

namespace pelage {

/// Value noise: random values in [-1, 1] on the lattice of whole numbers, blended smoothly between. |place| < 1e9.
double value_noise(glm::dvec3 place, std::uint64_t seed);

/// The same at one place for several seeds.
class ValueNoise {
 public:
  explicit ValueNoise(glm::dvec3 place);
  double operator()(std::uint64_t seed) const;

 private:
  glm::i64vec3 cell_;
  std::array<double, 8> shares_;  // of the cell's corners
};

}  // namespace pelage
