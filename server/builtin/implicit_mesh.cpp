#include "server/builtin/implicit_mesh.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <limits>
#include <numeric>

namespace pelage {
namespace {

constexpr std::uint32_t kNone = std::numeric_limits<std::uint32_t>::max();

// Six tetrahedra around a cube's diagonal, all positively oriented; bits 0, 1, 2 of a corner are its x, y, z.
constexpr std::array<std::array<int, 4>, 6> kTetrahedra = {
    {{0, 1, 3, 7}, {0, 3, 2, 7}, {0, 2, 6, 7}, {0, 6, 4, 7}, {0, 4, 5, 7}, {0, 5, 1, 7}}};

// For each set of inside corners an even permutation that lists the smaller of the two sides first
// (the inside ones where both have two).
constexpr std::array<std::array<int, 4>, 16> kOrder = {{{0, 1, 2, 3},
                                                        {0, 1, 2, 3},
                                                        {1, 0, 3, 2},
                                                        {0, 1, 2, 3},
                                                        {2, 3, 0, 1},
                                                        {0, 2, 3, 1},
                                                        {1, 2, 0, 3},
                                                        {3, 2, 1, 0},
                                                        {3, 2, 1, 0},
                                                        {0, 3, 1, 2},
                                                        {1, 3, 2, 0},
                                                        {2, 3, 0, 1},
                                                        {2, 3, 0, 1},
                                                        {1, 0, 3, 2},
                                                        {0, 1, 2, 3},
                                                        {0, 1, 2, 3}}};

class Polygoniser {
 public:
  Polygoniser(const ImplicitSurface& surface, double cell) : cell_(cell), origin_(surface.lower() - 2 * cell) {
    count_ = glm::ivec3(glm::ceil((surface.upper() + 2 * cell - origin_) / cell)) + 1;
    distance_.reserve(static_cast<std::size_t>(count_.x) * static_cast<std::size_t>(count_.y * count_.z));
    for (int z = 0; z < count_.z; ++z)
      for (int y = 0; y < count_.y; ++y) sample_row(surface, y, z);
    vertex_of_edge_.assign(7 * distance_.size(), kNone);
  }

  TriangleMesh run() {
    for (int z = 0; z + 1 < count_.z; ++z)
      for (int y = 0; y + 1 < count_.y; ++y)
        for (int x = 0; x + 1 < count_.x; ++x)
          for (const auto& corners : kTetrahedra) cut({x, y, z}, corners);
    return std::move(mesh_);
  }

 private:
  /// Far from the surface the next points need no look: they have the same sign.
  void sample_row(const ImplicitSurface& surface, int y, int z) {
    constexpr double kSafe = 0.4;  // a flattened volume's distance may be too large, though never twice
    for (int x = 0; x < count_.x;) {
      const double distance = surface.sample(point({x, y, z})).distance;
      const int alike = std::clamp(static_cast<int>(kSafe * std::abs(distance) / cell_), 1, count_.x - x);
      distance_.insert(distance_.end(), static_cast<std::size_t>(alike), distance);
      x += alike;
    }
  }

  static glm::ivec3 shifted(glm::ivec3 cube, int corner) {
    return cube + glm::ivec3(corner & 1, (corner >> 1) & 1, corner >> 2);
  }
  glm::dvec3 point(glm::ivec3 at) const { return origin_ + cell_ * glm::dvec3(at); }
  std::size_t index(glm::ivec3 at) const {
    return (static_cast<std::size_t>(at.z) * static_cast<std::size_t>(count_.y) + static_cast<std::size_t>(at.y)) *
               static_cast<std::size_t>(count_.x) +
           static_cast<std::size_t>(at.x);
  }

  void cut(glm::ivec3 cube, const std::array<int, 4>& corners) {
    unsigned inside = 0;
    for (unsigned k = 0; k < 4; ++k) inside |= (distance_[index(shifted(cube, corners[k]))] < 0 ? 1u : 0u) << k;
    if (inside == 0 || inside == 15) return;
    const auto crossing = [&](std::size_t from, std::size_t to) {
      const auto& order = kOrder[inside];
      return vertex(cube, corners[static_cast<std::size_t>(order[from])], corners[static_cast<std::size_t>(order[to])]);
    };
    const bool two = inside == 3 || inside == 5 || inside == 6 || inside == 9 || inside == 10 || inside == 12;
    if (two) {
      const glm::uvec4 ring{crossing(0, 2), crossing(0, 3), crossing(1, 3), crossing(1, 2)};
      mesh_.triangles.emplace_back(ring.x, ring.y, ring.z);
      mesh_.triangles.emplace_back(ring.x, ring.z, ring.w);
      return;
    }
    const bool one_inside = inside == 1 || inside == 2 || inside == 4 || inside == 8;
    const glm::uvec3 face{crossing(0, 1), crossing(0, 2), crossing(0, 3)};
    mesh_.triangles.push_back(one_inside ? face : glm::uvec3(face.x, face.z, face.y));
  }

  /// The vertex on the edge between two corners. In a tetrahedron the lower corner's bits are part of the higher's.
  std::uint32_t vertex(glm::ivec3 cube, int from, int to) {
    const glm::ivec3 low = shifted(cube, std::min(from, to));
    const glm::ivec3 high = shifted(cube, std::max(from, to));
    const std::size_t edge = 7 * index(low) + static_cast<std::size_t>((from ^ to) - 1);
    if (vertex_of_edge_[edge] != kNone) return vertex_of_edge_[edge];
    const double at_low = distance_[index(low)], at_high = distance_[index(high)];
    // Away from the corners, so that no triangle vanishes.
    const double share = std::clamp(at_low / (at_low - at_high), 0.1, 0.9);
    vertex_of_edge_[edge] = static_cast<std::uint32_t>(mesh_.positions.size());
    mesh_.positions.push_back(glm::mix(point(low), point(high), share));
    return vertex_of_edge_[edge];
  }

  double cell_;
  glm::dvec3 origin_;
  glm::ivec3 count_{0};
  std::vector<double> distance_;
  std::vector<std::uint32_t> vertex_of_edge_;  // for each grid point the edges to its 7 higher neighbours
  TriangleMesh mesh_;
};

std::uint32_t root_of(std::vector<std::uint32_t>& parent, std::uint32_t vertex) {
  while (parent[vertex] != vertex) vertex = parent[vertex] = parent[parent[vertex]];
  return vertex;
}

}  // namespace

TriangleMesh polygonise(const ImplicitSurface& surface, double cell) { return Polygoniser(surface, cell).run(); }

TriangleMesh largest_part(const TriangleMesh& mesh) {
  std::vector<std::uint32_t> parent(mesh.positions.size());
  std::iota(parent.begin(), parent.end(), 0u);
  for (const glm::uvec3& face : mesh.triangles)
    for (int k = 1; k < 3; ++k) parent[root_of(parent, face[k])] = root_of(parent, face.x);
  std::vector<std::size_t> count(parent.size(), 0);
  for (const glm::uvec3& face : mesh.triangles) ++count[root_of(parent, face.x)];
  const auto largest = static_cast<std::uint32_t>(std::max_element(count.begin(), count.end()) - count.begin());

  TriangleMesh part;
  std::vector<std::uint32_t> renamed(parent.size(), kNone);
  for (const glm::uvec3& face : mesh.triangles) {
    if (root_of(parent, face.x) != largest) continue;
    glm::uvec3& kept = part.triangles.emplace_back();
    for (int k = 0; k < 3; ++k) {
      if (renamed[face[k]] == kNone) {
        renamed[face[k]] = static_cast<std::uint32_t>(part.positions.size());
        part.positions.push_back(mesh.positions[face[k]]);
      }
      kept[k] = renamed[face[k]];
    }
  }
  return part;
}

}  // namespace pelage
