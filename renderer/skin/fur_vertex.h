// What fields say at a vertex, as strands grow by it and as shells read it (renderer/shaders/paint_attributes.glsl).
#pragma once

#include "renderer/input/fur_scene.h"

namespace pelage {

/// No padding.
struct FurVertex {
  glm::vec2 direction{0};  // in (tangent, bitangent)
  float length = 0;        // as bare skin and paint leave it, sizes
  float density = 1, width = 1, wetness = 0;
  float bare = 0;  // painted
  float curl = 0, clump = 0;
  glm::vec4 root_paint{0}, tip_paint{0};  // times its cover, cover
};
static_assert(sizeof(FurVertex) == 17 * sizeof(float));

/// Of a vertex at a place with a normal. What is not painted is at rest.
FurVertex fur_vertex(const FurFields& fields, std::size_t vertex, glm::vec3 place, glm::vec3 normal);

}  // namespace pelage
