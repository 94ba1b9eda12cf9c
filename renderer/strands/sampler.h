// Low-discrepancy samples: a Sobol sequence with Owen scrambling by hashes (Burley 2020), so that each pixel and each
// pair of dimensions has its own.
#pragma once

#include <cstdint>
#include <glm/glm.hpp>

namespace pelage {

/// The numbers of one sample of one pixel, asked for in a fixed order. The first 2^k samples of a pixel are stratified
/// in each pair. Deterministic in its three arguments.
class Sampler {
 public:
  Sampler(std::uint32_t pixel, std::uint32_t sample, std::uint32_t seed);

  float next();       // [0, 1)
  glm::vec2 next2();  // [0, 1)^2, stratified together

 private:
  std::uint32_t key_, sample_;  // key_: of pixel and seed
  std::uint32_t dimension_ = 0;
};

}  // namespace pelage
