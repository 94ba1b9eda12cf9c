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

/// Returns the matrix from world to clip space (FrameBlock::world_to_clip).
glm::mat4 world_to_clip(const FurFrame& frame);

/// Returns the size at which shaders take the finest texels of the coat's slices, sizes. It is larger the more the
/// drawn picture is enlarged: texels chosen for the drawn pixels are blurred once more by enlarging, texels chosen for
/// the displayed pixels flicker; this is halfway between, in the logarithm. `pixels`: height at which the picture is
/// drawn.
double finest_texel(const FurFrame& frame, int pixels);

/// `pixels`: height at which the picture is drawn. Depth is reversed and infinite: 1 at the near plane, 0 far away, so
/// that shells stay distinct at any distance (science.md 1).
FrameBlock make_frame_block(const FurFrame& frame, const Slices& slices, bool model_has_colours, int pixels);

// The view of the model from each light, and the uniform block of renderer/shaders/shadow.glsl.

/// The view from a light that contains the whole model: orthographic for directional lights. Depth is reversed as in a
/// frame.
struct LightView {
  glm::mat4 world_to_clip{1};
  glm::vec3 viewpoint{0};  // far away for a directional light
  glm::vec4 axis{0};       // linear depth of a position, sizes: dot(axis.xyz, position) + axis.w
  float texel = 0;         // size of a texel of its map at distance 1 from the viewpoint, sizes
};

/// Returns half of a light's width over its distance: for a directional light the tangent of its half angle, at most 2
/// (63 degrees), for other lights at distance 1.
float spread_of(const FurLight& light);

/// Returns the view from a light; none if the light is within 1.1 `radius` of the origin, because one map cannot
/// contain the model then.
std::optional<LightView> view_of_light(const FurLight& light, float radius, int resolution);

struct ShadowBlock {
  std::array<glm::mat4, max_lights> to_light{};
  std::array<glm::vec4, max_lights> axis{};
  // Slot of the shell maps or -1; slot of the depth map or -1; edge of the cast shadow: 0 hard, 1 soft, 2 penumbra; the
  // soft shadow's scale, or the penumbra's half width over the distance to its caster, times the distance to the light,
  // or -1 for no shadow.
  std::array<glm::vec4, max_lights> slots{};
};
static_assert(sizeof(ShadowBlock) == 8 * (64 + 16 + 16));

// The uniform block of renderer/shaders/bare_skin_block.glsl, in std140 layout.

struct SkinEntry {
  glm::vec4 across{0}, up{0}, along{0};  // rows to the unit ball; w: softness, 1 / min radius, cosine of full facing
  glm::vec4 centre{0};                   // w: scatter
  glm::vec4 facing{0};                   // w: cosine below which there is nothing of the region
  glm::vec4 colour{0};                   // w: shine
  glm::vec4 finish{0};                   // roughness, wetness, height and size of the bumps
};

struct SkinBlock {
  glm::uvec4 count{0};
  std::array<glm::vec4, limits::skin_regions> balls{};  // bounding spheres: centre, square of the radius
  std::array<SkinEntry, limits::skin_regions> regions{};
};
static_assert(sizeof(SkinBlock) == 16 * (1 + 64 * 8));

/// Takes at most 64 regions.
SkinBlock make_skin_block(std::span<const FurSkinRegion> regions);

}  // namespace pelage
