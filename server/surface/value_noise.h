// Smooth noise in space, the same for every run.
#pragma once

#include <cstdint>
#include <glm/glm.hpp>

namespace pelage {

/// Value noise: random values in [-1, 1] on the lattice of whole numbers, blended smoothly between. |place| < 1e9.
double value_noise(glm::dvec3 place, std::uint64_t seed);

}  // namespace pelage
