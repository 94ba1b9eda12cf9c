// The curve that a strand follows when it leans (science.md 2; fur modelling 5.1). Pure formulas;
// renderer/shaders/lean.glsl holds the same ones for the GPU and tests/gl compares both on a grid.
#pragma once

#include <glm/glm.hpp>

namespace pelage {

enum class LeanCurve { arc, root };  // science.md 2: the arc, and y = K sqrt(x)

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
