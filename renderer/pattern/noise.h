// Noise that is a pure function of place, stream and seed, the same on CPU and GPU (renderer/shaders/pattern.glsl).
#pragma once

#include <cstdint>

#include <glm/glm.hpp>

namespace pelage {

/// Three numbers in [0, 1) for a cell: PCG3D (Jarzynski, Olano 2020).
glm::vec3 random_of_cell(glm::ivec3 cell, std::uint32_t stream, std::uint32_t seed);

/// Gradient noise (Perlin 2002) of one swell per unit: mean 0, standard deviation .24, seldom beyond +-.7.
float gradient_noise(glm::vec3 place, std::uint32_t stream, std::uint32_t seed);

/// Distance to the nearest of points scattered one to a unit cell, each distance divided by the point's own size in
/// [.8, 1.1]; at most .62.
float cell_distance(glm::vec3 place, std::uint32_t stream, std::uint32_t seed);

}  // namespace pelage
