// The curve that a strand follows when it leans, and the direction in which it leans (science.md 2; fur modelling
// 5.1). renderer/shaders/lean.glsl holds the same formulas for the GPU; tests/gl compares both on a grid.
#pragma once

#include <glm/glm.hpp>

namespace pelage {

enum class LeanCurve { arc, root };  // science.md 2: the arc, and y = K sqrt(x)

/// How a strand leans: its inclination in [0, 1], and the unit vector along the skin that it leans to.
template <class Number>
struct Lean {
  Number inclination;
  glm::vec<3, Number> along;
};

/// The lean that a value of the direction field has in the frame of a unit normal and tangent. Upright fur leans along
/// the tangent by 0. renderer/shaders/lean.glsl has the same.
template <class Number>
Lean<Number> lean_of(glm::vec<2, Number> direction, glm::vec<3, Number> normal, glm::vec<3, Number> tangent) {
  const Number length = glm::length(direction);
  const glm::vec<2, Number> heading =
      length > Number(1e-6) ? direction / length : glm::vec<2, Number>(Number(1), Number(0));
  return {glm::min(length, Number(1)), heading.x * tangent + heading.y * glm::cross(normal, tangent)};
}

/// A place on the curve of a strand of length 1: how far it has gone along the lean and up the normal, and the angle of
/// its tangent from the normal in radians.
struct LeanPoint {
  double across = 0;
  double up = 0;
  double angle = 0;
};

/// The place at `s` in [0, 1] for an inclination in [0, 1] and a root share in [0, 1]. Exact in length for both curves:
/// the length of the curve up to s is s. No singularity: an inclination of 0 is the straight strand.
LeanPoint lean_point(LeanCurve curve, double inclination, double root_share, double s);

}  // namespace pelage
