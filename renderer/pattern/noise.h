// Noise that is a pure function of place, stream and seed, the same on CPU and GPU (renderer/shaders/pattern.glsl).
#pragma once

#include <cstdint>
#include <glm/glm.hpp>

namespace pelage {

/// Three numbers in [0, 1) for a cell: PCG3D (Jarzynski, Olano 2020).
glm::vec3 random_of_cell(glm::ivec3 cell, std::uint32_t stream, std::uint32_t seed);

/// Gradient noise (Perlin 2002) of one swell per unit: mean 0, standard deviation .19, seldom beyond +-.6.
float gradient_noise(glm::vec3 place, std::uint32_t stream, std::uint32_t seed);

/// Distance along a surface of this normal (unit) to the nearest of points scattered one to a unit cell, over the
/// point's own size: in [.8, 1.1], shrinking to nothing for points half a unit off the surface. At most .62.
float cell_distance(glm::vec3 place, glm::vec3 normal, std::uint32_t stream, std::uint32_t seed);

}  // namespace pelage
