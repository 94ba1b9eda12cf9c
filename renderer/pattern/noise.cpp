#include "renderer/pattern/noise.h"

namespace pelage {

namespace {

struct Stream {
  std::uint32_t stream, seed;

  float slope(glm::ivec3 cell, glm::ivec3 corner, glm::vec3 inside) const {
    return glm::dot(2.0f * random_of_cell(cell + corner, stream, seed) - 1.0f, inside - glm::vec3(corner));
  }
};

}  // namespace

glm::vec3 random_of_cell(glm::ivec3 cell, std::uint32_t stream, std::uint32_t seed) {
  const std::uint32_t key = seed * 0x9e3779b9u + stream * 0x85ebca6bu;
  glm::uvec3 v = glm::uvec3(cell) + key * glm::uvec3(1u, 0xc2b2ae35u, 0x27d4eb2fu);
  v = v * 1664525u + 1013904223u;
  v.x += v.y * v.z;
  v.y += v.z * v.x;
  v.z += v.x * v.y;
  v ^= v >> 16u;
  v.x += v.y * v.z;
  v.y += v.z * v.x;
  v.z += v.x * v.y;
  return glm::vec3(v >> 8u) * (1.0f / 16777216.0f);
}

float gradient_noise(glm::vec3 place, std::uint32_t stream, std::uint32_t seed) {
  const glm::vec3 low = glm::floor(place), f = place - low;
  const glm::ivec3 cell(low);
  const glm::vec3 w = f * f * f * (f * (f * 6.0f - 15.0f) + 10.0f);
  const Stream noise{stream, seed};
  float sums[4];
  for (int i = 0; i < 4; ++i) {
    const glm::ivec3 corner(0, i & 1, i >> 1);
    sums[i] = glm::mix(noise.slope(cell, corner, f), noise.slope(cell, corner + glm::ivec3(1, 0, 0), f), w.x);
  }
  return glm::mix(glm::mix(sums[0], sums[1], w.y), glm::mix(sums[2], sums[3], w.y), w.z);
}

float cell_distance(glm::vec3 place, glm::vec3 normal, std::uint32_t stream, std::uint32_t seed) {
  const glm::ivec3 cell(glm::floor(place - 0.5f));
  float nearest = 0.62f;
  for (int i = 0; i < 8; ++i) {
    const glm::ivec3 at = cell + glm::ivec3(i & 1, (i >> 1) & 1, i >> 2);
    const glm::vec3 random = random_of_cell(at, stream, seed);
    const glm::vec3 apart = glm::vec3(at) + 0.2f + 0.6f * random - place;
    const float off = glm::dot(apart, normal);
    const float size = (0.8f + 0.3f * glm::fract(random.x * 16.0f)) * (1 - glm::smoothstep(0.3f, 0.5f, glm::abs(off)));
    nearest = glm::min(nearest, glm::length(apart - off * normal) / glm::max(size, 1e-3f));
  }
  return nearest;
}

}  // namespace pelage
