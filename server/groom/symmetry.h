// Moving commands to their images under a symmetry or to another model: a visit of every position in a command.
#pragma once

#include "protocol/commands/command.h"
#include "server/surface/surface.h"

namespace pelage {

/// Maps the positions of a command. Positions and lengths are in the model's coordinates and unit.
class PlaceMap {
 public:
  virtual ~PlaceMap() = default;
  virtual glm::dvec3 place(glm::dvec3 position) const = 0;    // through space
  virtual glm::dvec3 on_skin(glm::dvec3 position) const = 0;  // of what lies on the skin or near it
  virtual SurfaceSample on_skin(const SurfaceSample& place) const = 0;
  virtual glm::dvec3 direction(glm::dvec3 direction) const = 0;
  virtual glm::dvec3 normal(glm::dvec3 normal) const = 0;  // of a plane
  virtual double length(double length) const = 0;
  virtual bool mirrors() const = 0;
};

/// Moves the places, directions and lengths of a command made on `surface`. Strokes lose their views, which are of what
/// was drawn: front faces are then judged by the skin, and a radius in pixels is that of the first sample. Gives
/// whether a place of a tool was moved, so that an image of it makes sense.
bool move_command(Command& command, const PlaceMap& map, const Surface& surface);

}  // namespace pelage
