// The same tool for a model that has been moved.
#pragma once

#include <vector>

#include "protocol/commands/command.h"
#include "server/surface/surface.h"

namespace pelage::testing_commands {

/// A turn or a mirror image, a scale and a shift, in this order.
struct Motion {
  glm::dmat3 turn{1};  // orthogonal
  double scale = 1;
  glm::dvec3 shift{0};

  glm::dvec3 place(glm::dvec3 p) const { return scale * (turn * p) + shift; }
};

/// Places, directions and lengths of a tool without views, moved from one model to the other. Relative lengths become
/// lengths in the model's own unit first, since a turned model has another box.
/// Both have the same triangles in the same order; `places` holds the other number of each vertex.
Command moved(const Command& command, const Motion& motion, const Surface& from, const Surface& to,
              const std::vector<std::uint32_t>& places);

/// Other numbers for the vertices that a mask lists.
void renumber_vertices(Command& command, const std::vector<std::uint32_t>& places);

}  // namespace pelage::testing_commands
