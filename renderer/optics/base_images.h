// The base-colour pictures of a model, with the levels that a GPU would have.
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "renderer/input/fur_scene.h"

namespace pelage {

/// All of one size, as layers of one texture; a level halves both sides. Texels are sRGB, alpha is not read.
struct BaseImages {
  struct Level {
    int width = 1, height = 1;
    std::int32_t first = 0;  // texel of the first image
  };
  std::vector<Level> levels;
  std::vector<std::int32_t> texels;  // RGBA8, red lowest; image by image in each level
  std::array<float, 256> linear{};   // of a channel

  BaseImages() = default;
  explicit BaseImages(std::span<const ImageView> images);
  bool empty() const { return levels.empty(); }
};

}  // namespace pelage
