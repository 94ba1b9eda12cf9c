// Vertex colours of most formats are sRGB; the house works in linear light.
#pragma once

#include <cmath>
#include <glm/glm.hpp>

namespace pelage {

/// Each channel in [0, 1]; others are clamped, NaN stays.
inline glm::vec3 srgb_to_linear(glm::vec3 colour) {
  for (int i = 0; i < 3; ++i) {
    const float c = colour[i] < 0 ? 0 : (colour[i] > 1 ? 1 : colour[i]);
    colour[i] = c <= 0.04045f ? c / 12.92f : std::pow((c + 0.055f) / 1.055f, 2.4f);
  }
  return colour;
}

}  // namespace pelage
