// Fur that the wind moves, or the body.
#pragma once

#include <glm/glm.hpp>
#include <vector>

namespace pelage {

/// The direction field of each coat that is seen, in the scene's order, at a moment.
using MovedFur = std::vector<std::vector<glm::vec2>>;

}  // namespace pelage
