// Limits on the positions and lengths of a request, relative to the model.
#pragma once

#include <glm/glm.hpp>
#include <string>
#include <utility>

#include "base/limits.h"
#include "base/status.h"

namespace pelage {

/// Returns whether a position in internal coordinates lies within limits::command_coordinate_sizes along each axis;
/// false for NaN.
inline bool reachable(glm::dvec3 internal) {
  const glm::dvec3 distance = glm::abs(internal);
  return distance.x <= limits::command_coordinate_sizes && distance.y <= limits::command_coordinate_sizes &&
         distance.z <= limits::command_coordinate_sizes;
}

inline bool reachable_length(double internal) { return internal <= limits::command_coordinate_sizes; }

inline Status out_of_reach(std::string pointer) {
  return failure(Code::invalid, "too far from the model", std::move(pointer), "at most 1e6 sizes of the model");
}

}  // namespace pelage
