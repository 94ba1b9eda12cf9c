// The uniform block of renderer/shaders/bare_skin.glsl, laid out as std140 wants it.
#pragma once

#include <array>
#include <glm/glm.hpp>
#include <span>

#include "protocol/base/limits.h"
#include "renderer/input/fur_scene.h"

namespace pelage {

struct SkinEntry {
  glm::vec4 across{0}, up{0}, along{0};  // rows to the unit ball; w: softness, 1 / least radius, cosine of whole facing
  glm::vec4 centre{0};                   // w: scatter
  glm::vec4 facing{0};                   // w: cosine of no facing
  glm::vec4 colour{0};                   // w: shine
  glm::vec4 finish{0};                   // roughness, wetness, height and size of the bumps
};

struct SkinBlock {
  glm::uvec4 count{0};
  std::array<glm::vec4, limits::skin_regions>
      balls{};  // around all that a region colours: centre, square of the radius
  std::array<SkinEntry, limits::skin_regions> regions{};
};
static_assert(sizeof(SkinBlock) == 16 * (1 + 64 * 8));

/// At most 64 regions.
SkinBlock make_skin_block(std::span<const FurSkinRegion> regions);

}  // namespace pelage
