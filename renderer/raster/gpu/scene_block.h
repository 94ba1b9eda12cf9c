// The uniforms that all stages share: RasterBlock of scene.glsl, which describes the members, in the layout std140.
#pragma once

#include <array>
#include <cstdint>
#include <glm/glm.hpp>

#include "renderer/raster/raster_scene.h"
#include "renderer/shaders/constants.h"

namespace pelage {

/// How many knots, lit points and tile entries the buffers have room for.
struct StageCapacities {
  std::uint32_t knots = 0, lit_points = 0, entries = 0;
  bool operator==(const StageCapacities&) const = default;
};

struct SceneBlock {
  glm::vec3 camera_position{0};
  float camera_scale = 1;
  glm::vec3 camera_right{0};
  float oversampling = 1;
  glm::vec3 camera_up{0};
  float over_view = 1;
  glm::vec3 camera_forward{0};
  float wetness = 0;
  glm::vec2 camera_middle{0};
  glm::ivec2 tiles{0};
  glm::ivec4 box{0};
  glm::vec3 grid_low{0};
  float grid_cell = 1;
  glm::ivec3 grid_size{2};
  std::uint32_t grid_there = 0;
  float near_cell = 1;
  std::uint32_t fur_groups = 0, near_there = 0, directional_lights = 0;
  std::int32_t shading_model = 0;
  std::uint32_t light_count = 0, key_furthest = 0;
  std::int32_t key_shift = 0;
  std::uint32_t triangle_count = 0, strand_count = 0, knot_capacity = 0, entry_capacity = 0;
  std::uint32_t lit_point_capacity = 0, texel_levels = 0, model_colours = 0;
  std::int32_t eye_count = 0;
  float ground_height = 0, ground_contact = 0, ground_shadow = 0, sky_cell = 1;
  glm::vec2 sky_low{0};
  glm::ivec2 sky_size{0};
  std::int32_t eye_steps = 0;
  std::array<std::int32_t, 3> unused{};
  std::array<glm::vec4, max_lights> light_widths{};
  std::array<glm::ivec4, max_eyes> eye_boxes{};
};
static_assert(sizeof(SceneBlock) == 16 * (15 + max_lights + max_eyes));

/// Returns the block of a box. `strands`: StrandPlan::strands.
SceneBlock scene_block(const RasterScene& scene, const PixelBox& box, std::uint32_t strands,
                       const StageCapacities& rooms);

}  // namespace pelage
