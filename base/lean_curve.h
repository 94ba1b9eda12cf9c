// The curve that a strand follows when it leans, and the direction in which it leans (science.md 2; fur modelling
// 5.1). renderer/shaders/lean.glsl holds the same formulas for the GPU; tests/gl compares both on a grid.
#pragma once

#include <glm/glm.hpp>

namespace pelage {

enum class LeanCurve { arc, root };  // science.md 2: a circular arc, and the parabola y = K sqrt(x)

/// How a strand leans: its inclination in [0, 1], and the unit vector along the skin towards which it leans.
template <class Number>
struct Lean {
  Number inclination;
  glm::vec<3, Number> along;
};

/// Converts a value of the direction field to a Lean in the frame of a unit normal and tangent. Upright fur has
/// inclination 0 and the heading of the tangent. renderer/shaders/lean.glsl has the same function.
template <class Number>
Lean<Number> lean_of(glm::vec<2, Number> direction, glm::vec<3, Number> normal, glm::vec<3, Number> tangent) {
  const Number length = glm::length(direction);
  const glm::vec<2, Number> heading =
      length > Number(1e-6) ? direction / length : glm::vec<2, Number>(Number(1), Number(0));
  return {glm::min(length, Number(1)), heading.x * tangent + heading.y * glm::cross(normal, tangent)};
}

/// A point on the curve of a strand of length 1: its distances from the root along the lean and along the normal, and
/// the angle between its tangent and the normal in radians.
struct LeanPoint {
  double across = 0;
  double up = 0;
  double angle = 0;
};

/// Returns the point at `s` in [0, 1] for an inclination in [0, 1] and a root share in [0, 1]. Both curves have the
/// length 1, and `s` is the arc length from the root. There is no singularity: an inclination of 0 gives the straight
/// strand.
LeanPoint lean_point(LeanCurve curve, double inclination, double root_share, double s);

}  // namespace pelage
