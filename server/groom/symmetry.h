// Transforms commands to their symmetry images or to another model, by visiting every position in a command.
#pragma once

#include "protocol/commands/command.h"
#include "server/surface/surface.h"

namespace pelage {

/// A transform of the positions of a command. Positions and lengths are in the model's coordinates and unit.
class PositionMap {
 public:
  virtual ~PositionMap() = default;
  virtual glm::dvec3 mapped(glm::dvec3 position) const = 0;   // of a position anywhere in space
  virtual glm::dvec3 on_skin(glm::dvec3 position) const = 0;  // of a position on the skin or near it
  virtual SurfaceSample on_skin(const SurfaceSample& sample) const = 0;
  virtual glm::dvec3 direction(glm::dvec3 direction) const = 0;
  virtual glm::dvec3 normal(glm::dvec3 normal) const = 0;  // of a plane
  virtual double length(double length) const = 0;
  virtual bool mirrors() const = 0;
};

/// Transforms the positions, directions and lengths of a command made on `surface`. Strokes lose their views, which
/// show the original: the front-facing test then uses the skin's normal, and a radius in pixels becomes that of the
/// first sample. Returns whether the command has positions that make its image a different command.
bool move_command(Command& command, const PositionMap& map, const Surface& surface);

}  // namespace pelage
