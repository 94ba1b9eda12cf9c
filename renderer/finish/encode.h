// Encodes linear light as the numbers of a picture; compiled for several instruction sets.
#pragma once

#include <cstdint>
#include <glm/glm.hpp>

namespace pelage {

/// Maximum number of pixels encoded at once; rows are padded to a multiple of it.
inline constexpr int encode_batch = 16;

struct Encoding {
  float exposure = 1;  // factor
  bool filmic = false, transparent = false, studio = false;
  glm::vec3 background{0};     // linear
  int width = 0, height = 0;   // pixels of the picture
  std::int32_t largest = 255;  // largest value of a channel
};

/// Encodes a row of premultiplied linear light as straight sRGB in [0, largest], four numbers a pixel each. `overlay`:
/// sRGB with straight alpha to lay over it, or null; where its alpha is 1, the pixel becomes opaque. All rows are
/// padded.
void encode_row(const Encoding& encoding, int row, const float* light, const float* overlay, std::int32_t* numbers);

}  // namespace pelage
