// The plan of a box: which strands of which parts it may show, as the stages read it (plan.glsl).
#pragma once

#include <array>
#include <cstdint>
#include <glm/glm.hpp>
#include <vector>

#include "renderer/raster/gpu/strand_pool.h"
#include "renderer/raster/raster_scene.h"

namespace pelage {

inline constexpr std::uint32_t strand_group = 64;  // strands of one part that a work group handles together

/// Part of plan.glsl, which describes the members.
struct PlannedPart {
  glm::vec3 to_camera{0};
  float min_facing = 0;
  std::uint32_t points = 0, words = 0, count = 0, kept = 0;
  float exact = 0, width_factor = 1;
  std::uint32_t first = 0, number = 0;
  std::int32_t segments = 1;
  std::uint32_t is_curve = 0, has_mean = 0;
  std::uint32_t last = 0;
  std::uint32_t lit_of = 1;
  float own_colour = 1, wider = 1, packing = 0;
  float crowding = 1;
  float coat = 1;  // coat_number
  std::array<float, 2> unused{};
};
static_assert(sizeof(PlannedPart) == 96);

struct StrandPlan {
  std::vector<glm::uvec2> groups;  // index of the part in `parts`, first strand of the group in that part
  std::vector<PlannedPart> parts;

  /// Returns the number of strands, counting each group as full.
  std::uint32_t strands() const { return static_cast<std::uint32_t>(groups.size()) * strand_group; }
};

StrandPlan strand_plan(const RasterScene& scene, const PixelBox& box, const StrandPool& pool);

}  // namespace pelage
