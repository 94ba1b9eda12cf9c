// The values of the fur's fields at a vertex, from which strands grow and which shells read
// (renderer/shaders/paint_attributes.glsl).
#pragma once

#include "renderer/input/fur_scene.h"

namespace pelage {

/// The values at a vertex. No padding.
struct FurVertex {
  glm::vec2 direction{0};  // in (tangent, bitangent)
  float length = 0;        // length of the fur, after bare skin and paint, sizes
  float density = 1, width = 1, wetness = 0;
  float bare = 0;  // painted bareness, [0, 1]
  float curl = 0, clump = 0;
  glm::vec4 root_paint{0}, tip_paint{0};  // colour times cover, cover
};
static_assert(sizeof(FurVertex) == 17 * sizeof(float));

/// Returns the values at a vertex with a position and a normal. Unpainted fields have their defaults.
FurVertex fur_vertex(const FurFields& fields, std::size_t vertex, glm::vec3 position, glm::vec3 normal);

}  // namespace pelage
