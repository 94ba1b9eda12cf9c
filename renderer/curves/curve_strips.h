// Smooth curves through points (Catmull and Rom 1974), and the strips of triangles that draw them.
#pragma once

#include <glm/glm.hpp>
#include <span>
#include <vector>

#include "renderer/input/fur_scene.h"

namespace pelage {

/// The place at `t` in [0, 1], evenly from point to point: at t = i / (n - 1) exactly points[i]. Needs n of 2 or more.
/// Beyond its ends the curve goes on as it came, so two points give a straight line. Finite for points that coincide.
glm::dvec3 spline_point(std::span<const glm::dvec3> points, double t);

// Groups of guided curves as lines of points: guides are evaluated and others filled in between them.

inline constexpr int curve_segments = 48;

/// What a curve looks like.
struct CurveStyle {
  glm::vec4 root{0}, tip{0};  // colour, linear; width, sizes
  glm::vec4 normal{0};        // of the skin at the root, unit; a random number in [0, 1)
  bool operator==(const CurveStyle&) const = default;
};
static_assert(sizeof(CurveStyle) == 48);

struct CurveStrips {
  std::vector<glm::vec3> points;   // curve_segments + 1 for each curve, root first
  std::vector<CurveStyle> styles;  // for each curve
};

/// In the order of the groups and their guides. Guides are taken as they are; what is filled in between two of them is
/// their mix, and strays by the group's spread in place (half of the way to the next curve), length (by a half) and
/// direction (30 degrees around its root). Deterministic.
CurveStrips make_strips(std::span<const FurCurves> groups);

}  // namespace pelage
