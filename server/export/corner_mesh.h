// The triangles of all fur patches of a scene as one mesh, and the positions of vertices at a height of the fur.
#pragma once

#include <cstdint>
#include <glm/glm.hpp>
#include <vector>

#include "server/scene/scene.h"

namespace pelage {

/// A mesh of the patches' triangles. Corners with the same vertex and the same position on the tile are merged.
struct CornerMesh {
  struct Corner {
    std::uint32_t vertex = 0;
    glm::vec2 tile_uv{0};  // position on the sample tile, sizes
    float weight = 1;      // the patch's share of the fur, [0, 1]
  };
  std::vector<Corner> corners;
  std::vector<glm::uvec3> triangles;  // indices of corners
};

/// Returns the mesh of the fur; if `whole`, with the triangles without fur, too.
CornerMesh make_corner_mesh(const SceneView& scene, bool whole = false);

/// Returns the positions of all vertices of the mesh at a height s in [0, 1] of their fur, in the model's unit and
/// relative to its centre.
std::vector<glm::vec3> positions_at(const SceneView& scene, double s);

}  // namespace pelage
