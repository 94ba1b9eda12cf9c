// Colours that are painted in numbers that can be added and averaged.
#pragma once

#include <glm/glm.hpp>

#include "protocol/commands/field.h"

namespace pelage {

/// A field's value in numbers that add up. A colour is multiplied by how much it covers, so that one that covers
/// nothing does not count; other fields are as they are.
inline glm::dvec4 to_summable(Field field, glm::dvec4 value) {
  return shape_of(field).channels == 4 ? glm::dvec4(glm::dvec3(value) * value.w, value.w) : value;
}

/// The way back. A colour that covers nothing is black.
inline glm::dvec4 from_summable(Field field, glm::dvec4 sum) {
  if (shape_of(field).channels != 4) return sum;
  return sum.w > 0 ? glm::dvec4(glm::dvec3(sum) / sum.w, sum.w) : glm::dvec4(0);
}

}  // namespace pelage
