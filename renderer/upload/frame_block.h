// The uniform block of renderer/shaders/frame.glsl, laid out as std140 wants it.
#pragma once

#include <array>
#include <glm/glm.hpp>

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

/// `pixels` is the height that is drawn. Depth is reversed and infinite: 1 at the near plane, 0 far away, so that
/// shells stay apart at any distance (science.md 1).
FrameBlock make_frame_block(const FurFrame& frame, const Slices& slices, bool model_has_colours, int pixels);

}  // namespace pelage
