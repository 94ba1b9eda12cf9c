// Resizes a picture of light.
#pragma once

#include <array>
#include <glm/glm.hpp>
#include <vector>

#include "renderer/image/float_image.h"

namespace pelage {

class ResizedLight {
 public:
  /// `light` must outlive this. Its height over the picture's is the scale in both directions.
  ResizedLight(const FloatImage& light, int width, int height);

  /// Writes a row of the picture, four numbers a pixel.
  void row(int y, float* rgba) const;

 private:
  /// The taps of one pixel along one direction.
  struct Taps {
    std::array<int, 4> at{};         // pixels of `light`, clamped to its size
    std::array<float, 4> weights{};  // of the cubic of Catmull and Rom 1974
  };
  Taps taps(int pixel, int size) const;
  glm::vec4 texel(int x, int y) const;
  glm::vec4 enlarged(const Taps& across, const Taps& down) const;
  glm::vec4 mean(int x, int y) const;

  const FloatImage& light_;
  int width_ = 0;
  float scale_ = 1;  // height of the light over that of the picture
  std::vector<Taps> columns_;
};

/// Returns the resized light. The same bits for any number of threads.
FloatImage resized_light(const FloatImage& light, int width, int height, int threads);

}  // namespace pelage
