#include "server/builtin/builtin.h"

#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>
#include <cstdlib>
#include <functional>
#include <map>
#include <numbers>
#include <utility>

#include "server/builtin/creature.h"
#include "server/builtin/implicit.h"

namespace pelage {

RawModel triangle_model(std::vector<glm::dvec3> positions, const std::vector<glm::uvec3>& triangles) {
  RawModel model;
  model.positions = std::move(positions);
  model.face_sizes.assign(triangles.size(), 3);
  model.corners.reserve(3 * triangles.size());
  for (const glm::uvec3& t : triangles) model.corners.insert(model.corners.end(), {t.x, t.y, t.z});
  return model;
}

RawModel make_builtin(const BuiltinModel& model) {
  switch (model.shape) {
    case Builtin::torus: return make_torus(model.triangles);
    case Builtin::knot: return make_knot(model.triangles);
    case Builtin::sphere: return make_sphere(model.triangles);
    case Builtin::plane: return make_plane(model.triangles);
    case Builtin::cloth: return make_cloth(model.triangles);
    case Builtin::creature: return make_creature(model.triangles);
  }
  assert(false);
  return {};
}

// Built-ins that are sheets: one parametric patch, open or closed to a torus.

namespace {

using glm::dvec2;
using glm::dvec3;

constexpr double kTurn = 2 * std::numbers::pi;

/// Cells of a parametric sheet, each cut into two triangles.
struct SheetGrid {
  int columns = 1, rows = 1;
  bool closed = false;  // the last column joins the first, and the last row the first
};

/// Returns a grid of about square cells for a sheet that is `aspect` times as wide as high.
SheetGrid grid_for(int triangles, double aspect, int min_columns, int min_rows, bool closed) {
  const double cells = triangles / 2.0;
  const int rows = std::max(min_rows, static_cast<int>(std::lround(std::sqrt(cells / aspect))));
  const int columns = std::max(min_columns, static_cast<int>(std::lround(cells / rows)));
  return {columns, rows, closed};
}

using Sheet = std::function<dvec3(dvec2)>;  // from [0, 1] x [0, 1]; dP/du x dP/dv points outwards

/// Returns the sheet's own coordinates at the corners of its triangles, from 0 to 1 across the whole sheet.
std::vector<dvec2> sheet_uvs(const SheetGrid& grid) {
  std::vector<dvec2> uvs;
  for (int j = 0; j < grid.rows; ++j)
    for (int i = 0; i < grid.columns; ++i) {
      const auto uv = [&](int di, int dj) {
        return dvec2(static_cast<double>(i + di) / grid.columns, static_cast<double>(j + dj) / grid.rows);
      };
      const dvec2 a = uv(0, 0), b = uv(1, 0), c = uv(1, 1), d = uv(0, 1);
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
      // Diagonals alternate, so that the sheet bends equally in both directions.
      if ((i + j) % 2 == 0)
        triangles.insert(triangles.end(), {{a, b, c}, {a, c, d}});
      else
        triangles.insert(triangles.end(), {{a, b, d}, {b, c, d}});
    }
  RawModel model = triangle_model(std::move(positions), triangles);
  model.corner_uv = sheet_uvs(grid);
  return model;
}

/// Returns a point of a tube along the trefoil. The knot lies on a torus, which gives the tube a frame that closes
/// without a twist.
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

/// Returns a point of a square sheet, 2 x 2, on a round table: flat in the middle, hanging in folds around the edge.
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

// The built-in sphere: a platonic solid whose faces are subdivided evenly.

namespace {

/// A platonic solid with triangular faces, corners on the unit sphere.
struct Solid {
  std::vector<dvec3> corners;
  std::vector<glm::uvec3> faces;
};

Solid tetrahedron() {
  const double s = 1 / std::sqrt(3.0);
  return {{{s, s, s}, {s, -s, -s}, {-s, s, -s}, {-s, -s, s}}, {{0, 1, 2}, {0, 3, 1}, {0, 2, 3}, {1, 3, 2}}};
}

Solid octahedron() {
  return {{{1, 0, 0}, {-1, 0, 0}, {0, 1, 0}, {0, -1, 0}, {0, 0, 1}, {0, 0, -1}},
          {{0, 2, 4}, {2, 1, 4}, {1, 3, 4}, {3, 0, 4}, {2, 0, 5}, {1, 2, 5}, {3, 1, 5}, {0, 3, 5}}};
}

Solid icosahedron() {
  const double g = std::numbers::phi;
  Solid solid{{{-1, g, 0},
               {1, g, 0},
               {-1, -g, 0},
               {1, -g, 0},
               {0, -1, g},
               {0, 1, g},
               {0, -1, -g},
               {0, 1, -g},
               {g, 0, -1},
               {g, 0, 1},
               {-g, 0, -1},
               {-g, 0, 1}},
              {{0, 11, 5},  {0, 5, 1},  {0, 1, 7},  {0, 7, 10}, {0, 10, 11}, {1, 5, 9}, {5, 11, 4},
               {11, 10, 2}, {10, 7, 6}, {7, 1, 8},  {3, 9, 4},  {3, 4, 2},   {3, 2, 6}, {3, 6, 8},
               {3, 8, 9},   {4, 9, 5},  {2, 4, 11}, {6, 2, 10}, {8, 6, 7},   {9, 8, 1}}};
  for (dvec3& corner : solid.corners) corner = glm::normalize(corner);
  return solid;
}

/// Cuts each face of a solid into `cuts` by `cuts` triangles on the sphere.
class Geodesic {
 public:
  Geodesic(const Solid& solid, int cuts) : solid_(solid), cuts_(cuts) {
    angle_ = std::acos(glm::dot(solid.corners[solid.faces[0].x], solid.corners[solid.faces[0].y]));
  }

  RawModel run() {
    for (const glm::uvec3& face : solid_.faces)
      for (int i = 0; i < cuts_; ++i)
        for (int j = 0; i + j < cuts_; ++j) {
          const std::uint32_t a = vertex(face, i, j), b = vertex(face, i + 1, j), c = vertex(face, i, j + 1);
          triangles_.emplace_back(a, b, c);
          if (i + j + 1 < cuts_) triangles_.emplace_back(b, vertex(face, i + 1, j + 1), c);
        }
    return triangle_model(std::move(positions_), triangles_);
  }

 private:
  // The solid's corners that a vertex lies between, in order, each with its share; unused ones are (0, 0).
  using Key = std::array<std::pair<std::uint32_t, int>, 3>;

  std::uint32_t vertex(const glm::uvec3& face, int i, int j) {
    Key key = {{{face.x, cuts_ - i - j}, {face.y, i}, {face.z, j}}};
    for (auto& [corner, share] : key)
      if (share == 0) corner = 0;
    std::sort(key.begin(), key.end());
    const auto [found, fresh] = known_.try_emplace(key, static_cast<std::uint32_t>(positions_.size()));
    if (fresh) positions_.push_back(position_of(key));
    return found->second;
  }

  /// Returns the position of a vertex. Equal angles along a face's edges keep the triangles about equal.
  dvec3 position_of(const Key& key) const {
    dvec3 sum{0};
    for (const auto& [corner, share] : key) sum += std::sin(share * angle_ / cuts_) * solid_.corners[corner];
    return glm::normalize(sum);
  }

  const Solid& solid_;
  int cuts_;
  double angle_;
  std::map<Key, std::uint32_t> known_;
  std::vector<dvec3> positions_;
  std::vector<glm::uvec3> triangles_;
};

int nearest_cuts(const Solid& solid, int triangles) {
  return std::max(1, static_cast<int>(std::lround(std::sqrt(triangles / static_cast<double>(solid.faces.size())))));
}

/// Returns by how many triangles the best subdivision of the solid differs from the requested count.
int miss(const Solid& solid, int triangles) {
  const int cuts = nearest_cuts(solid, triangles);
  return std::abs(static_cast<int>(solid.faces.size()) * cuts * cuts - triangles);
}

}  // namespace

RawModel make_sphere(int triangles) {
  // More faces give more even triangles, so a solid with fewer must be closer to the count by a tenth of it.
  Solid best = icosahedron();
  for (const Solid& solid : {octahedron(), tetrahedron()})
    if (miss(solid, triangles) < miss(best, triangles) - triangles / 10) best = solid;
  return Geodesic(best, nearest_cuts(best, triangles)).run();
}

// The built-in creature: its volumes polygonised and painted.

namespace {

TriangleMesh creature_mesh(int triangles) {
  constexpr double kCell = 0.0125;            // the ears are about three cells thick
  constexpr int kEvenest = 2000, kMin = 400;  // below kEvenest, even triangles lose the ears; below kMin, the legs
  static const ImplicitSurface surface(creature_volumes());
  static const TriangleMesh fine = largest_part(polygonise(surface, kCell));  // the same for all counts
  const TriangleMesh even = remesh(surface, fine, std::max(triangles, kEvenest));
  return triangles < kEvenest ? decimate(even, std::max(triangles, kMin)) : even;
}

}  // namespace

RawModel make_creature(int triangles) {
  const TriangleMesh mesh = creature_mesh(triangles);
  RawModel model = triangle_model(mesh.positions, mesh.triangles);
  std::vector<glm::vec4> colours;
  for (const glm::dvec3& position : model.positions) {
    const CreatureLook look = creature_look(position);
    colours.emplace_back(look.colour, 1);
    model.length_scale.push_back(static_cast<float>(look.length_scale));
  }
  for (const std::uint32_t corner : model.corners) model.corner_colour.push_back(colours[corner]);
  return model;
}

}  // namespace pelage
