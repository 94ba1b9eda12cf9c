// The soft edge of a cast shadow (GPU fur 4): where skin is hidden from a light, and how wide the shadow is around a
// place.
#pragma once

#include <glm/glm.hpp>
#include <span>
#include <vector>

#include "renderer/marched/depth_map.h"

namespace pelage {

/// Of each texel of a light's map whether skin that faces the light is hidden from it (1 or 0), and then the depth of
/// what the light sees there.
std::vector<glm::vec2> occlusion_map(std::span<const glm::vec3> places, std::span<const glm::vec3> normals,
                                     std::span<const glm::uvec3> triangles, const LightView& light,
                                     const DepthMap& depths, int threads);

/// Texels along the side of the map of widths for maps of a resolution: the paper reduces 512 to a quarter; the blur
/// must not shrink with finer maps, so a texel is about .03 sizes wide.
int shadow_width_side(int resolution);

/// The occlusion map reduced: its mean over twice a texel's width, whose grey near an edge stands for the distance to
/// it.
std::vector<glm::vec2> shadow_widths(std::span<const glm::vec2> occlusion, int side);

}  // namespace pelage
