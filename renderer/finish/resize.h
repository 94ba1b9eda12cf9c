// Light of one size at the pixels of a picture of another.
#pragma once

#include <array>
#include <glm/glm.hpp>
#include <vector>

#include "renderer/image/float_image.h"

namespace pelage {

class ResizedLight {
 public:
  /// `light` outlives this. Its height over the picture's is the scale of both directions.
  ResizedLight(const FloatImage& light, int width, int height);

  /// A row of the picture, four numbers a pixel.
  void row(int y, float* rgba) const;

 private:
  /// What one pixel takes along one direction.
  struct Taps {
    std::array<int, 4> at{};         // of the light, held inside it
    std::array<float, 4> weights{};  // the cubic of Catmull and Rom 1974
  };
  Taps taps(int pixel, int size) const;
  glm::vec4 texel(int x, int y) const;
  glm::vec4 enlarged(const Taps& across, const Taps& down) const;
  glm::vec4 mean(int x, int y) const;

  const FloatImage& light_;
  int width_ = 0;
  float scale_ = 1;  // size of the light over that of the picture
  std::vector<Taps> columns_;
};

/// All rows of it. The same bits for any number of threads.
FloatImage resized_light(const FloatImage& light, int width, int height, int threads);

}  // namespace pelage
