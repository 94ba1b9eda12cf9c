// A smooth curve through points (Catmull and Rom 1974).
#pragma once

#include <glm/glm.hpp>
#include <span>

namespace pelage {

/// The place at `t` in [0, 1], evenly from point to point: at t = i / (n - 1) exactly points[i]. Needs n of 2 or more.
/// Beyond its ends the curve goes on as it came, so two points give a straight line. Finite for points that coincide.
glm::dvec3 spline_point(std::span<const glm::dvec3> points, double t);

}  // namespace pelage
