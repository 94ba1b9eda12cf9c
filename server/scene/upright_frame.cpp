#include "server/scene/upright_frame.h"

#include <cmath>

namespace pelage {

glm::dmat3 upright_frame(glm::dvec3 forward) {
  forward = glm::normalize(forward);
  const glm::dvec3 guide = std::abs(forward.y) < 0.999 ? glm::dvec3(0, 1, 0) : glm::dvec3(0, 0, -forward.y);
  const glm::dvec3 right = glm::normalize(glm::cross(guide, forward));
  return {right, glm::cross(forward, right), forward};
}

glm::dmat3 tilted(const glm::dmat3& frame, double angle) {
  const double c = std::cos(angle), s = std::sin(angle);
  return {frame[0] * c + frame[1] * s, frame[1] * c - frame[0] * s, frame[2]};
}

}  // namespace pelage
