// The base-colour images of a model with mip levels, for the CPU.
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "renderer/input/fur_scene.h"

namespace pelage {

/// All images have one size, as in an array texture; a level halves both sides. Texels are sRGB, alpha is not read.
struct BaseImages {
  struct Level {
    int width = 1, height = 1;
    std::int32_t first = 0;  // index of the first image's first texel
  };
  std::vector<Level> levels;
  std::vector<std::int32_t> texels;  // RGBA8, red lowest; image by image in each level
  std::array<float, 256> linear{};   // linear value of each sRGB byte

  BaseImages() = default;
  explicit BaseImages(std::span<const ImageView> images);
  bool empty() const { return levels.empty(); }
};

}  // namespace pelage
