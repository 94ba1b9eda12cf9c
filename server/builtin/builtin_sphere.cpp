// The built-in sphere: a platonic solid whose faces are cut up evenly.
#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>
#include <map>
#include <numbers>
#include <utility>

#include "server/builtin/builtin_shapes.h"

namespace pelage {
namespace {

using glm::dvec3;

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
    if (fresh) positions_.push_back(place(key));
    return found->second;
  }

  /// Even steps of the angle along a face's edges, which keeps the triangles about equal.
  dvec3 place(const Key& key) const {
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

/// By how many triangles the solid misses the wished-for count.
int miss(const Solid& solid, int triangles) {
  const int cuts = nearest_cuts(solid, triangles);
  return std::abs(static_cast<int>(solid.faces.size()) * cuts * cuts - triangles);
}

}  // namespace

RawModel make_sphere(int triangles) {
  // The more faces the evener, so a solid with fewer must come closer by a tenth of the count.
  Solid best = icosahedron();
  for (const Solid& solid : {octahedron(), tetrahedron()})
    if (miss(solid, triangles) < miss(best, triangles) - triangles / 10) best = solid;
  return Geodesic(best, nearest_cuts(best, triangles)).run();
}

}  // namespace pelage
