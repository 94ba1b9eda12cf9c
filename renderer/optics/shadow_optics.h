// Maps of the shadows that a body and its guided curves cast, as plain numbers: penumbras of
// renderer/shaders/shadow.glsl.
#pragma once

#include <glm/glm.hpp>

namespace pelage {

/// A light that casts a shadow. Maps are seen from it, rows from the top.
struct ShadowCaster {
  glm::mat4 to_light{1};
  glm::vec4 axis{0};              // linear depth: dot(xyz, place) + w, sizes
  float spread = 0;               // half of the light's width over its distance; of a light at a place, at distance 1
  int side = 0;                   // texels of the maps
  const float* depths = nullptr;  // of the fur's hull; null for a light that casts none
  const glm::vec2* curves = nullptr;  // light that curves let through, and depth of the nearest; null for no curves
};

}  // namespace pelage
