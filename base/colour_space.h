// Luminance and the sRGB transfer curve. Colours are linear Rec. 709.
#pragma once

#include <cmath>
#include <glm/glm.hpp>

namespace pelage {

/// Rec. 709 luminance. renderer/shaders/luminance.glsl holds the same weights for the GPU.
inline float luminance(glm::vec3 linear) { return glm::dot(linear, glm::vec3(0.2126f, 0.7152f, 0.0722f)); }
inline double luminance(const glm::dvec3& linear) { return glm::dot(linear, glm::dvec3(0.2126, 0.7152, 0.0722)); }

/// The sRGB curve (IEC 61966-2-1). Its linear part continues below 0, its power law above 1.
template <class T>
T linear_from_srgb(T encoded) {
  return encoded <= T(0.04045) ? encoded / T(12.92) : std::pow((encoded + T(0.055)) / T(1.055), T(2.4));
}
template <class T>
T srgb_from_linear(T linear) {
  return linear <= T(0.0031308) ? linear * T(12.92) : T(1.055) * std::pow(linear, T(1 / 2.4)) - T(0.055);
}

}  // namespace pelage
