// Maps of the shadows that a body, its fur and its guided curves cast, as plain numbers: those of
// renderer/shaders/shadow.glsl.
#pragma once

#include <glm/glm.hpp>

namespace pelage {

/// Light that the shells above let through (GPU fur 3.1), as a light sees it.
struct ShellShadow {
  glm::mat4 to_light{1};
  int side = 0;                 // texels of the maps
  const float* kept = nullptr;  // at shadow_boundaries heights, the skin first, each side * side; null for none
};

/// Of the shadow that one part of a body casts on another (CastShadow).
enum class ShadowEdge { none, hard, soft, penumbra };

/// A light that has maps. They are seen from it, rows from the top.
struct ShadowCaster {
  glm::mat4 to_light{1};
  glm::vec4 axis{0};  // linear depth: dot(xyz, place) + w, sizes
  ShadowEdge edge = ShadowEdge::none;
  float spread = 0;               // half of the light's width over its distance; of a light at a place, at distance 1
  float scale = 1;                // of a soft edge's width
  int side = 0, width_side = 0;   // texels of the maps, and of the widths
  const float* depths = nullptr;  // of the fur's hull for a penumbra, else of the skin; null for a light without maps
  const glm::vec2* widths = nullptr;  // of a soft edge: share of shadow nearby, and its mean times what casts it
  const glm::vec2* curves = nullptr;  // light that curves let through, and depth of the nearest; null for no curves
  ShellShadow shells;
};

}  // namespace pelage
