#include "server/surface/shading_normals.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <numeric>
#include <optional>

#include "server/surface/adjacency.h"
#include "server/surface/prepare.h"

namespace pelage {

namespace {

/// Disjoint sets of corners (three for each triangle) that form one smooth surface.
class SmoothCorners {
 public:
  explicit SmoothCorners(std::size_t corners) : parents_(corners) { std::iota(parents_.begin(), parents_.end(), 0u); }

  std::uint32_t root(std::uint32_t corner) {
    while (parents_[corner] != corner) corner = parents_[corner] = parents_[parents_[corner]];
    return corner;
  }
  void join(std::uint32_t a, std::uint32_t b) { parents_[root(a)] = root(b); }

 private:
  std::vector<std::uint32_t> parents_;
};

/// Returns the corners of a side's triangle at its lower and at its higher vertex.
std::array<std::uint32_t, 2> ends_of(const Side& side) {
  const std::uint32_t first = 3 * side.triangle + side.side, second = 3 * side.triangle + (side.side + 1) % 3;
  return side.rising ? std::array{first, second} : std::array{second, first};
}

/// Separates corners at sharp edges, and records the vertices at which such edges end.
class Creases {
 public:
  Creases(std::span<const glm::dvec3> area_vectors, const std::vector<glm::uvec3>& triangles, std::size_t vertices,
          double degrees)
      : area_vectors_(area_vectors),
        cosine_(std::cos(glm::radians(degrees))),
        smooth_(3 * triangles.size()),
        creased_(vertices, false) {
    for_each_edge(sorted_sides(triangles), [&](std::span<const Side> edge) { look_at(edge); });
  }

  bool any() const { return any_; }
  bool at(std::uint32_t vertex) const { return creased_[vertex]; }
  std::uint32_t surface_of(std::uint32_t corner) { return smooth_.root(corner); }

 private:
  bool is_sharp(const Side& a, const Side& b) const {
    const glm::dvec3 u = area_vectors_[a.triangle], v = area_vectors_[b.triangle];
    const double across = a.rising == b.rising ? -glm::dot(u, v) : glm::dot(u, v);
    return across < cosine_ * glm::length(u) * glm::length(v);
  }

  void look_at(std::span<const Side> edge) {
    if (edge.size() == 1) return;
    if (edge.size() > 2 || is_sharp(edge[0], edge[1])) {
      any_ = creased_[edge[0].low] = creased_[edge[0].high] = true;
      return;
    }
    const auto a = ends_of(edge[0]), b = ends_of(edge[1]);
    smooth_.join(a[0], b[0]), smooth_.join(a[1], b[1]);
  }

  std::span<const glm::dvec3> area_vectors_;
  double cosine_;
  SmoothCorners smooth_;
  std::vector<bool> creased_;
  bool any_ = false;
};

/// Returns for each vertex the sum, over its open edges, of the unit vectors that lie in the edge's triangle,
/// orthogonal to the edge, and point out of it.
std::vector<glm::dvec3> over_rims(const std::vector<glm::vec3>& positions, const std::vector<glm::uvec3>& triangles) {
  std::vector<glm::dvec3> sums(positions.size(), glm::dvec3(0));
  for_each_edge(sorted_sides(triangles), [&](std::span<const Side> edge) {
    if (edge.size() != 1) return;
    const glm::uvec3& t = triangles[edge[0].triangle];
    const auto corner = [&](std::uint32_t k) { return glm::dvec3(positions[t[static_cast<int>(k % 3)]]); };
    const std::uint32_t k = edge[0].side;
    const glm::dvec3 along = corner(k + 1) - corner(k), across = corner(k + 2) - corner(k);
    const glm::dvec3 out = along * glm::dot(along, across) - across * glm::dot(along, along);
    const double length = glm::length(out);
    if (!(length > 0)) return;
    sums[edge[0].low] += out / length, sums[edge[0].high] += out / length;
  });
  return sums;
}

glm::vec3 unit_or(glm::dvec3 vector, glm::vec3 fallback) {
  const double length = glm::length(vector);
  return length > 0 ? glm::vec3(vector / length) : fallback;
}

}  // namespace

std::vector<std::array<glm::vec3, 3>> shading_normals(std::span<const glm::dvec3> positions,
                                                      const std::vector<glm::uvec3>& triangles,
                                                      std::span<const glm::vec3> normals, double crease_degrees) {
  if (crease_degrees >= 180) return {};
  std::vector<glm::dvec3> area_vectors;
  for (const glm::uvec3& t : triangles)
    area_vectors.push_back(glm::cross(positions[t.y] - positions[t.x], positions[t.z] - positions[t.x]));
  Creases creases(area_vectors, triangles, positions.size(), crease_degrees);
  if (!creases.any()) return {};
  std::vector<glm::dvec3> sums(3 * triangles.size(), glm::dvec3(0));
  for (std::uint32_t corner = 0; corner < sums.size(); ++corner)
    sums[creases.surface_of(corner)] += area_vectors[corner / 3];
  std::vector<std::array<glm::vec3, 3>> result(triangles.size());
  for (std::uint32_t corner = 0; corner < sums.size(); ++corner) {
    const std::uint32_t vertex = triangles[corner / 3][static_cast<int>(corner % 3)];
    result[corner / 3][corner % 3] =
        creases.at(vertex) ? unit_or(sums[creases.surface_of(corner)], normals[vertex]) : normals[vertex];
  }
  return result;
}

std::vector<std::uint32_t> grow_over_creases(const std::vector<glm::uvec3>& triangles,
                                             const std::vector<std::array<glm::vec3, 3>>& shading_normals,
                                             std::vector<glm::vec3>& normals) {
  constexpr float cancelled = 0.1f;
  std::vector<std::vector<glm::vec3>> sides(normals.size());  // the shading normals that differ from the vertex's
  for (std::size_t t = 0; t < shading_normals.size(); ++t) {
    for (std::size_t k = 0; k < 3; ++k) {
      const std::uint32_t v = triangles[t][static_cast<int>(k)];
      const glm::vec3 side = shading_normals[t][k];
      const bool known = std::find(sides[v].begin(), sides[v].end(), side) != sides[v].end();
      if (side != normals[v] && !known) sides[v].push_back(side);
    }
  }
  std::vector<std::uint32_t> changed;
  for (std::uint32_t v = 0; v < normals.size(); ++v) {
    const glm::vec3 sum = std::accumulate(sides[v].begin(), sides[v].end(), glm::vec3(0));
    if (glm::length(sum) > cancelled) normals[v] = glm::normalize(sum), changed.push_back(v);
  }
  return changed;
}

void lean_over_rims(Mesh& mesh) {
  constexpr double cancelled = 0.1;
  const std::vector<glm::dvec3> over_rim = over_rims(mesh.positions, mesh.triangles);
  const auto at_rim = [&](std::uint32_t v) { return glm::length(over_rim[v]) > cancelled; };
  std::vector<std::vector<glm::vec3>> sides(over_rim.size());  // shading normals of vertices at rims
  const bool split = !mesh.shading_normals.empty();
  std::vector<std::array<glm::vec3, 3>> seen(mesh.triangles.size());
  for (std::size_t t = 0; t < seen.size(); ++t) {
    for (std::size_t k = 0; k < 3; ++k) {
      const std::uint32_t v = mesh.triangles[t][static_cast<int>(k)];
      seen[t][k] = split ? mesh.shading_normals[t][k] : mesh.normals[v];
      const bool known = std::find(sides[v].begin(), sides[v].end(), seen[t][k]) != sides[v].end();
      if (at_rim(v) && !known) sides[v].push_back(seen[t][k]);
    }
  }
  bool any = false;
  for (std::uint32_t v = 0; v < over_rim.size(); ++v) {
    if (!at_rim(v)) continue;
    const glm::vec3 out(glm::normalize(over_rim[v]));
    const glm::dvec3 sum(std::accumulate(sides[v].begin(), sides[v].end(), out));
    if (!(glm::length(sum) > cancelled)) continue;
    mesh.normals[v] = glm::vec3(glm::normalize(sum));
    mesh.tangents[v] = glm::vec3(tailward(glm::normalize(sum)));
    any = true;
  }
  if (any) mesh.shading_normals = std::move(seen);
}

}  // namespace pelage
