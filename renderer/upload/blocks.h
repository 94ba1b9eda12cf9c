// The uniform blocks of a frame, its shadows and its bare skin (renderer/shaders/frame.glsl), laid out as std140.
#pragma once

#include <array>
#include <glm/glm.hpp>
#include <optional>
#include <span>
#include <vector>

#include "base/limits.h"
#include "renderer/coat/slices.h"
#include "renderer/input/fur_scene.h"
#include "renderer/shaders/constants.h"

namespace pelage {

struct LightBlock {
  glm::vec4 direction{0}, position{0}, radiance{0};
};

struct FrameBlock {
  glm::mat4 world_to_clip{1};
  glm::vec4 viewpoint{0}, half_picture{0}, weights{0}, exponents{0}, skin{0}, counts{0}, tile{0};
  std::array<glm::vec4, slice_levels> depth_scale{};
  std::array<glm::vec4, slice_count / 4> depth_above{};
  std::array<glm::vec4, slice_count> colour_above{};
  glm::vec4 ramp_root{0};
  std::array<LightBlock, max_lights> lights{};
  std::array<glm::vec4, 9> environment{};
};
static_assert(sizeof(FrameBlock) == 64 + 16 * (7 + 8 + 8 + 32 + 1 + 24 + 9));

/// From the world to the picture (FrameBlock::world_to_clip).
glm::mat4 world_to_clip(const FurFrame& frame);

/// Size of the finest texels of the coat's slices, sizes: larger the more a picture of part size is enlarged. Texels
/// for the pixels that are drawn are blurred once more by enlarging, texels for those that are shown flicker. So
/// halfway, in the logarithm. `pixels` is the height that is drawn.
double finest_texel(const FurFrame& frame, int pixels);

/// `pixels` is the height that is drawn. Depth is reversed and infinite: 1 at the near plane, 0 far away, so that
/// shells stay apart at any distance (science.md 1).
FrameBlock make_frame_block(const FurFrame& frame, const Slices& slices, bool model_has_colours, int pixels);

// How each light sees the model, and the uniform block of renderer/shaders/shadow.glsl.

/// The view of a light that holds the whole model: orthographic for directional lights. Depth is reversed as in a
/// frame.
struct LightView {
  glm::mat4 world_to_clip{1};
  glm::vec3 viewpoint{0};  // far away for a directional light
  glm::vec4 axis{0};       // linear depth of a place in sizes: dot(axis.xyz, place) + axis.w
  float texel = 0;         // size of a map's texel at distance 1 from the eye, for maps of `resolution`
};

/// Half of a light's width over its distance; of one that is somewhere, at distance 1. At most 2, an angle of 63
/// degrees.
float spread_of(const FurLight& light);

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

// The uniform block of renderer/shaders/bare_skin.glsl, laid out as std140 wants it.

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
