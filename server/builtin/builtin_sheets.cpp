// Built-ins that are sheets: one parametric patch, open or closed to a torus.
#include <algorithm>
#include <cmath>
#include <functional>
#include <numbers>

#include "server/builtin/builtin_shapes.h"

namespace pelage {
namespace {

using glm::dvec2;
using glm::dvec3;

constexpr double kTurn = 2 * std::numbers::pi;

/// Cells of a parametric sheet, each cut into two triangles.
struct SheetGrid {
  int columns = 1, rows = 1;
  bool closed = false;  // the last column joins the first, and the last row the first
};

/// About square cells for a sheet that is `aspect` times as wide as high.
SheetGrid grid_for(int triangles, double aspect, int least_columns, int least_rows, bool closed) {
  const double cells = triangles / 2.0;
  const int rows = std::max(least_rows, static_cast<int>(std::lround(std::sqrt(cells / aspect))));
  const int columns = std::max(least_columns, static_cast<int>(std::lround(cells / rows)));
  return {columns, rows, closed};
}

using Sheet = std::function<dvec3(dvec2)>;  // from [0, 1] x [0, 1]; dP/du x dP/dv points outwards

/// The sheet's own coordinates at the corners of its triangles, from 0 to 1 over each round.
std::vector<dvec2> sheet_uvs(const SheetGrid& grid) {
  std::vector<dvec2> uvs;
  for (int j = 0; j < grid.rows; ++j)
    for (int i = 0; i < grid.columns; ++i) {
      const auto place = [&](int di, int dj) {
        return dvec2(static_cast<double>(i + di) / grid.columns, static_cast<double>(j + dj) / grid.rows);
      };
      const dvec2 a = place(0, 0), b = place(1, 0), c = place(1, 1), d = place(0, 1);
      if ((i + j) % 2 == 0)
        uvs.insert(uvs.end(), {a, b, c, a, c, d});
      else
        uvs.insert(uvs.end(), {a, b, d, b, c, d});
    }
  return uvs;
}

RawModel tessellate(const SheetGrid& grid, const Sheet& sheet) {
  const int across = grid.columns + (grid.closed ? 0 : 1), down = grid.rows + (grid.closed ? 0 : 1);
  std::vector<dvec3> positions;
  for (int j = 0; j < down; ++j)
    for (int i = 0; i < across; ++i)
      positions.push_back(sheet({static_cast<double>(i) / grid.columns, static_cast<double>(j) / grid.rows}));
  const auto vertex = [&](int i, int j) { return static_cast<std::uint32_t>((j % down) * across + i % across); };
  std::vector<glm::uvec3> triangles;
  for (int j = 0; j < grid.rows; ++j)
    for (int i = 0; i < grid.columns; ++i) {
      const std::uint32_t a = vertex(i, j), b = vertex(i + 1, j), c = vertex(i + 1, j + 1), d = vertex(i, j + 1);
      // Alternating diagonals, so that the sheet bends the same way in both.
      if ((i + j) % 2 == 0)
        triangles.insert(triangles.end(), {{a, b, c}, {a, c, d}});
      else
        triangles.insert(triangles.end(), {{a, b, d}, {b, c, d}});
    }
  RawModel model = triangle_model(std::move(positions), triangles);
  model.corner_uv = sheet_uvs(grid);
  return model;
}

/// A tube along the trefoil, which lies on a torus: the torus gives the tube a frame that closes without a twist.
dvec3 knot_point(dvec2 uv) {
  constexpr double kRing = 1, kWinding = 0.42, kTube = 0.21;
  const double t = kTurn * uv.x, about = kTurn * uv.y;
  const dvec3 outwards{std::cos(2 * t), std::sin(2 * t), 0};
  const dvec3 forwards{-std::sin(2 * t), std::cos(2 * t), 0};
  const dvec3 normal = std::cos(3 * t) * outwards + std::sin(3 * t) * dvec3(0, 0, 1);
  const dvec3 winding = -std::sin(3 * t) * outwards + std::cos(3 * t) * dvec3(0, 0, 1);
  const double reach = kRing + kWinding * std::cos(3 * t);
  const dvec3 tangent = glm::normalize(2 * reach * forwards + 3 * kWinding * winding);
  const dvec3 side = glm::cross(normal, tangent);
  return kRing * outwards + (kWinding + kTube * std::cos(about)) * normal + kTube * std::sin(about) * side;
}

/// A square sheet, 2 x 2, laid over a round table's edge: flat in the middle, hanging in folds around it.
dvec3 cloth_point(dvec2 uv) {
  constexpr double kFlat = 0.35, kBend = 0.45, kDroop = 1.25;  // radius of the top, arc's radius, steepest angle
  const dvec2 flat{2 * uv.x - 1, 1 - 2 * uv.y};
  const double from_centre = glm::length(flat);
  if (from_centre <= kFlat) return {flat.x, 0, flat.y};
  const double beyond = from_centre - kFlat;
  const double angle = std::min(beyond / kBend, kDroop), straight = beyond - kBend * angle;
  const double radius = kFlat + kBend * std::sin(angle) + straight * std::cos(angle);
  const double fall = kBend * (1 - std::cos(angle)) + straight * std::sin(angle);
  const double turn = std::atan2(flat.y, flat.x);
  const double fold = 0.15 * beyond * beyond * std::sin(12 * turn + 0.6 + 0.7 * std::sin(3 * turn));
  const double sway = 0.03 * std::sin(3.1 * flat.x + 1.7 * flat.y) * beyond;
  return dvec3((radius + fold) / from_centre * flat.x, sway - fall, (radius + fold) / from_centre * flat.y);
}

}  // namespace

RawModel make_torus(int triangles) {
  constexpr double kRing = 1, kTube = 0.4;
  return tessellate(grid_for(triangles, kRing / kTube, 3, 3, true), [](dvec2 uv) {
    const double around = kTurn * uv.x, about = kTurn * uv.y;
    const double reach = kRing + kTube * std::cos(about);
    return dvec3(reach * std::cos(around), reach * std::sin(around), kTube * std::sin(about));
  });
}

RawModel make_knot(int triangles) {
  constexpr double kLengthOverTubeGirth = 11.4;
  return tessellate(grid_for(triangles, kLengthOverTubeGirth, 24, 3, true), knot_point);
}

RawModel make_plane(int triangles) {
  return tessellate(grid_for(triangles, 1, 1, 1, false), [](dvec2 uv) { return dvec3(uv.x - 0.5, 0, 0.5 - uv.y); });
}

RawModel make_cloth(int triangles) { return tessellate(grid_for(triangles, 1, 1, 1, false), cloth_point); }

}  // namespace pelage
