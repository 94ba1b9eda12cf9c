// The hull of a model's fur, which stops the light that comes to other parts of the body.
#pragma once

#include <glm/glm.hpp>
#include <vector>

#include "protocol/commands/coat.h"
#include "renderer/marched/march_scene.h"

namespace pelage {

/// Places over the mesh's vertices, at hull_height of the fur.
std::vector<glm::vec3> fur_hull(const MarchMesh& mesh, const Coat& coat);

/// Of the ball about the origin that holds the body and its fur, sizes.
float radius_of_fur(const MarchMesh& mesh);

}  // namespace pelage
