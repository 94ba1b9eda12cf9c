// What is compiled for several instruction sets: light to the numbers of a picture.
#pragma once

#include <cstdint>
#include <glm/glm.hpp>

namespace pelage {

/// Pixels that are encoded at once at most; rows are padded to a multiple of it.
inline constexpr int encoded_together = 16;

struct Encoding {
  float exposure = 1;  // factor
  bool filmic = false, transparent = false, studio = false;
  glm::vec3 background{0};     // linear
  int width = 0, height = 0;   // pixels of the picture
  std::int32_t largest = 255;  // of a channel
};

/// A row of premultiplied linear light to straight sRGB in [0, largest], four numbers a pixel each. `overlay`: sRGB
/// with straight alpha over it, or null; where its alpha is 1, it hides what is transparent. All rows are padded.
void encode_row(const Encoding& encoding, int row, const float* light, const float* overlay, std::int32_t* numbers);

}  // namespace pelage
