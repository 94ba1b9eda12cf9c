// Fur moved by the wind or by the body.
#pragma once

#include <glm/glm.hpp>
#include <vector>

namespace pelage {

/// The direction field of each visible coat, in the scene's order, at one time.
using MovedFur = std::vector<std::vector<glm::vec2>>;

}  // namespace pelage
