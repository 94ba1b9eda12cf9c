// Smooth curves through points (Catmull and Rom 1974), and groups of guided curves as points for drawing.
#pragma once

#include <glm/glm.hpp>
#include <span>
#include <vector>

#include "renderer/input/fur_scene.h"

namespace pelage {

/// Returns the position at `t` in [0, 1], uniform in the index of points: at t = i / (n - 1) exactly points[i].
/// Requires n >= 2. The end points are extrapolated linearly, so two points give a straight line. Finite for points
/// that coincide.
glm::dvec3 spline_point(std::span<const glm::dvec3> points, double t);

// Groups of guided curves as polylines: guides are evaluated, and other curves are filled in between them.

inline constexpr int curve_segments = 48;

/// The look of a curve.
struct CurveStyle {
  glm::vec4 root{0}, tip{0};  // linear colour; width, sizes
  glm::vec4 normal{0};        // unit normal of the skin at the root; w: random number in [0, 1)
  bool operator==(const CurveStyle&) const = default;
};
static_assert(sizeof(CurveStyle) == 48);

struct CurveStrips {
  std::vector<glm::vec3> points;   // curve_segments + 1 for each curve, root first
  std::vector<CurveStyle> styles;  // for each curve
};

/// Returns the curves in the order of the groups and their guides. Guides are used as they are. A filled curve is a mix
/// of the two guides around it, varied by the group's spread in position (up to half the distance to the next curve),
/// length (up to a half) and direction (up to 30 degrees about its root). Deterministic.
CurveStrips make_strips(std::span<const FurCurves> groups);

}  // namespace pelage
