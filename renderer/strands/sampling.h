// A 64-bit hash for change detection, random samplers, discrete distributions, and the local frame of a fibre.
#pragma once

#include <array>
#include <cstdint>
#include <cstring>
#include <glm/glm.hpp>
#include <span>
#include <type_traits>

#include "base/colour_space.h"
#include "base/random.h"

namespace pelage {

class Hash {
 public:
  void add(std::uint64_t word) { state_ = mix_bits(state_ ^ word); }
  void add(double value) { add_bits(value); }

  /// Adds values of a type without padding.
  template <class T>
  void add_values(std::span<const T> values) {
    static_assert(std::is_trivially_copyable_v<T> && sizeof(T) % 4 == 0);
    const auto* from = reinterpret_cast<const unsigned char*>(values.data());
    std::size_t left = values.size_bytes();
    add(static_cast<std::uint64_t>(left));
    for (; left >= 8; left -= 8, from += 8) {
      std::uint64_t word = 0;
      std::memcpy(&word, from, 8);
      add(word);
    }
    std::uint64_t rest = 0;
    std::memcpy(&rest, from, left);
    if (left > 0) add(rest);
  }
  template <class T>
  void add_value(const T& value) {
    add_values(std::span<const T>(&value, 1));
  }

  std::uint64_t value() const { return state_; }

 private:
  template <class T>
  void add_bits(T value) {
    std::uint64_t word = 0;
    std::memcpy(&word, &value, sizeof value);
    add(word);
  }

  std::uint64_t state_ = 0;
};

// Low-discrepancy samples: a Sobol sequence with hash-based Owen scrambling (Burley 2020). Each pixel and each pair of
// dimensions is scrambled differently.

/// The random numbers of one sample of one pixel, drawn in a fixed order. The first 2^k samples of a pixel are
/// stratified in each pair of dimensions. Deterministic in its three arguments.
class Sampler {
 public:
  Sampler(std::uint32_t pixel, std::uint32_t sample, std::uint32_t seed);

  float next();       // [0, 1)
  glm::vec2 next2();  // [0, 1)^2, stratified together

 private:
  std::uint32_t key_, sample_;  // key_: hash of pixel and seed
  std::uint32_t dimension_ = 0;
};

// Discrete distributions with few weights, and directions about a normal.

/// A sample of a discrete distribution.
struct DiscreteSample {
  int index = -1;  // -1 where no weight is above 0
  float probability = 1;
};

/// A discrete distribution over up to nine weights: eight lights, then the environment.
class DiscreteDistribution {
 public:
  void add(float weight);                // negative weights count as 0
  DiscreteSample sample(float u) const;  // u in [0, 1)

 private:
  std::array<float, 9> weights_{};
  int count_ = 0;
  float total_ = 0;
};

/// Returns a unit vector orthogonal to a unit normal.
glm::vec3 any_perpendicular(glm::vec3 normal);

/// Returns a cosine-distributed direction about a unit normal: its pdf is its cosine to the normal over pi. u in [0,
/// 1)^2.
glm::vec3 cosine_direction(glm::vec3 normal, glm::vec2 u);

// The local frame of a strand in which renderer/shading/fibre.h expresses directions.

/// The local frame of a fibre. Its first axis points from tip to root, its second across the fibre towards the camera,
/// so that the camera's azimuth is 0.
class FibreFrame {
 public:
  /// Both unit; `tangent` from root to tip.
  FibreFrame(glm::vec3 tangent, glm::vec3 to_camera) : axis_(-tangent) {
    const glm::vec3 across = to_camera - axis_ * glm::dot(axis_, to_camera);
    const float length = glm::length(across);
    towards_ = length > 1e-6f ? across / length : any_perpendicular(axis_);  // no azimuth along the strand
    aside_ = glm::cross(axis_, towards_);
  }

  glm::vec3 local(glm::vec3 v) const { return {glm::dot(v, axis_), glm::dot(v, towards_), glm::dot(v, aside_)}; }
  glm::vec3 world(glm::vec3 v) const { return v.x * axis_ + v.y * towards_ + v.z * aside_; }

 private:
  glm::vec3 axis_, towards_, aside_;
};

}  // namespace pelage
