// The pieces of a scene's fur as one mesh, and where its vertices stand at a height of the fur.
#pragma once

#include <cstdint>
#include <glm/glm.hpp>
#include <vector>

#include "server/scene/scene.h"

namespace pelage {

/// Corners of pieces with the same vertex and the same place on the tile are one.
struct CornerMesh {
  struct Corner {
    std::uint32_t vertex = 0;
    glm::vec2 tile_uv{0};  // sizes
    float weight = 1;      // share of the fur, [0, 1]
  };
  std::vector<Corner> corners;
  std::vector<glm::uvec3> triangles;  // of corners
};

/// Returns the mesh of the fur; if `whole`, with the triangles without fur too.
CornerMesh make_corner_mesh(const SceneView& scene, bool whole = false);

/// Places of all vertices of the mesh at a height s in [0, 1] of their fur, in the model's unit from its centre.
std::vector<glm::vec3> places_at(const SceneView& scene, double s);

}  // namespace pelage
