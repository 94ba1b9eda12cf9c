// Normals and tangents of vertices.
#pragma once

#include <glm/glm.hpp>
#include <vector>

#include "server/surface/soup.h"

namespace pelage {

struct Frames {
  std::vector<glm::vec3> normals;   // unit
  std::vector<glm::vec3> tangents;  // unit, orthogonal to the normals
};

/// Area-weighted normals; where they cancel, that of the vertex's first triangle. Tangents point tailwards: the
/// surface part of -Z, of -Y where that vanishes. Every vertex belongs to a triangle with an area.
Frames make_frames(const Soup& soup);

/// The unit tangent of a surface with this unit normal that points tailwards.
glm::dvec3 tailward(glm::dvec3 normal);

}  // namespace pelage
