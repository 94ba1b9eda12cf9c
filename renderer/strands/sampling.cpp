#include "renderer/strands/sampling.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <numbers>

namespace pelage {

namespace {

/// Mixes all bits (the Murmur3 finalizer).
std::uint32_t hash(std::uint32_t x) {
  x ^= x >> 16;
  x *= 0x85ebca6bu;
  x ^= x >> 13;
  x *= 0xc2b2ae35u;
  return x ^ x >> 16;
}

std::uint32_t hash(std::uint32_t a, std::uint32_t b) { return hash(hash(a) + 0x9e3779b9u + b); }

std::uint32_t reverse_bits(std::uint32_t x) {
  x = x >> 16 | x << 16;
  x = (x & 0xff00ff00u) >> 8 | (x & 0x00ff00ffu) << 8;
  x = (x & 0xf0f0f0f0u) >> 4 | (x & 0x0f0f0f0fu) << 4;
  x = (x & 0xccccccccu) >> 2 | (x & 0x33333333u) << 2;
  return (x & 0xaaaaaaaau) >> 1 | (x & 0x55555555u) << 1;
}

/// Flips each bit by a hash of the bits below it (Laine and Karras 2011, Vegdahl's constants). On reversed bits this is
/// Owen scrambling.
std::uint32_t flip_by_lower(std::uint32_t x, std::uint32_t seed) {
  x ^= x * 0x3d20adeau;
  x += seed;
  x *= seed >> 16 | 1;
  x ^= x * 0x05526c56u;
  return x ^ x * 0x53a22864u;
}

/// Returns the second Sobol dimension of the sample x with its bits reversed: a product with Pascal's triangle modulo
/// 2, one factor for each bit of a bit's index.
std::uint32_t second_sobol_reversed(std::uint32_t x) {
  x ^= (x & 0xaaaaaaaau) >> 1;
  x ^= (x & 0xccccccccu) >> 2;
  x ^= (x & 0xf0f0f0f0u) >> 4;
  x ^= (x & 0xff00ff00u) >> 8;
  return x ^ x >> 16;
}

float unit_float(std::uint32_t x) { return static_cast<float>(x >> 8) * 0x1p-24f; }

}  // namespace

Sampler::Sampler(std::uint32_t pixel, std::uint32_t sample, std::uint32_t seed)
    : key_(hash(seed, pixel)), sample_(sample) {}

float Sampler::next() { return next2().x; }

glm::vec2 Sampler::next2() {
  const std::uint32_t pair = hash(key_, dimension_++);
  // Shuffling the indices by an Owen scramble maps the first 2^k of them to an aligned block of 2^k, which is a net
  // too.
  const std::uint32_t index = reverse_bits(flip_by_lower(reverse_bits(sample_), pair));
  // The first dimension is the index with its bits reversed.
  return {unit_float(reverse_bits(flip_by_lower(index, hash(pair, 1)))),
          unit_float(reverse_bits(flip_by_lower(second_sobol_reversed(index), hash(pair, 2))))};
}

void DiscreteDistribution::add(float weight) {
  assert(count_ < static_cast<int>(weights_.size()));
  weights_[static_cast<std::size_t>(count_)] = std::max(weight, 0.0f);
  total_ += weights_[static_cast<std::size_t>(count_++)];
}

DiscreteSample DiscreteDistribution::sample(float u) const {
  if (!(total_ > 0) || !std::isfinite(total_)) return {};
  float left = u * total_;
  int chosen = -1;  // if rounding passes the end, the last index with a weight
  for (int i = 0; i < count_; ++i) {
    const float weight = weights_[static_cast<std::size_t>(i)];
    if (!(weight > 0)) continue;
    chosen = i;
    if (left < weight) break;
    left -= weight;
  }
  return {chosen, weights_[static_cast<std::size_t>(chosen)] / total_};
}

glm::vec3 any_perpendicular(glm::vec3 normal) {
  const glm::vec3 axis = std::abs(normal.x) < 0.6f ? glm::vec3(1, 0, 0) : glm::vec3(0, 1, 0);
  return glm::normalize(glm::cross(normal, axis));
}

glm::vec3 cosine_direction(glm::vec3 normal, glm::vec2 u) {
  const float radius = std::sqrt(u.x), angle = 2 * std::numbers::pi_v<float> * u.y;
  const glm::vec3 across = any_perpendicular(normal), up = glm::cross(normal, across);
  const glm::vec3 direction = radius * (std::cos(angle) * across + std::sin(angle) * up) + std::sqrt(1 - u.x) * normal;
  return glm::normalize(direction);
}

}  // namespace pelage
