// How each light sees the model, and the uniform block of renderer/shaders/shadow.glsl.
#pragma once

#include <array>
#include <glm/glm.hpp>
#include <optional>
#include <vector>

#include "renderer/input/fur_scene.h"
#include "renderer/shaders/constants.h"

namespace pelage {

/// The view of a light that holds the whole model: orthographic for directional lights. Depth is reversed as in a
/// frame.
struct LightView {
  glm::mat4 world_to_clip{1};
  glm::vec3 viewpoint{0};  // far away for a directional light
  glm::vec4 axis{0};       // linear depth of a place in sizes: dot(axis.xyz, place) + axis.w
  float texel = 0;         // size of a map's texel at distance 1 from the eye, for maps of `resolution`
};

/// None for a light inside the model's surroundings (a ball of `radius` about the centre), which no one map holds.
std::optional<LightView> view_of_light(const FurLight& light, float radius, int resolution);

struct ShadowBlock {
  std::array<glm::mat4, max_lights> to_light{};
  std::array<glm::vec4, max_lights> axis{};
  // Slot of the shell maps or -1; slot of the depth map or -1; the cast shadow's edge: 0 hard, 1 soft, 2 a penumbra;
  // the soft one's scale, the penumbra's half width over the distance to what casts it times that to the light, -1 for
  // none.
  std::array<glm::vec4, max_lights> slots{};
};
static_assert(sizeof(ShadowBlock) == 8 * (64 + 16 + 16));

}  // namespace pelage
