// Moves a tool along with a model that has been moved.
#pragma once

#include <vector>

#include "protocol/commands/command.h"
#include "server/surface/surface.h"

namespace pelage::testing_commands {

/// An orthogonal transform, then a scale, then a shift.
struct Motion {
  glm::dmat3 turn{1};  // a rotation, perhaps with a mirror image
  double scale = 1;
  glm::dvec3 shift{0};

  glm::dvec3 mapped(glm::dvec3 p) const { return scale * (turn * p) + shift; }
};

/// Moves positions, directions and lengths of a tool without views from one model to the other. Relative lengths are
/// first converted to the model's own unit, since a turned model has another bounding box.
/// Both models have the same triangles in the same order; `new_indices[v]` is the new index of vertex `v`.
Command moved(const Command& command, const Motion& motion, const Surface& from, const Surface& to,
              const std::vector<std::uint32_t>& new_indices);

/// Renumbers the vertices that a mask lists: `new_indices[v]` is the new index of `v`.
void renumber_vertices(Command& command, const std::vector<std::uint32_t>& new_indices);

}  // namespace pelage::testing_commands
