#include "server/patches/flatten.h"

#include <Eigen/SparseCholesky>
#include <algorithm>
#include <cmath>
#include <limits>
#include <queue>

#include "server/surface/adjacency.h"

namespace pelage {

namespace {

glm::dvec2 rotated(glm::dvec2 v, double angle) {
  const double c = std::cos(angle), s = std::sin(angle);
  return {c * v.x - s * v.y, s * v.x + c * v.y};
}

/// Returns v rotated by the smallest rotation from one unit vector to another. Opposite vectors leave v unchanged.
glm::dvec3 transported(glm::dvec3 v, glm::dvec3 from, glm::dvec3 to) {
  const double cosine = glm::dot(from, to);
  if (cosine < -0.9999) return v;
  const glm::dvec3 axis = glm::cross(from, to), across = glm::cross(axis, v);
  return v + across + glm::cross(axis, across) / (1 + cosine);
}

/// Places vertices one after the other, nearest to the seed first, at the positions that their placed neighbours
/// predict.
class ExponentialMap {
 public:
  ExponentialMap(const Mesh& mesh, const Adjacency& neighbours, FlatPatch& patch)
      : mesh_(mesh),
        patch_(patch),
        neighbours_(neighbours),
        tangent_angles_(patch.vertices.size(), 0),
        placed_(patch.vertices.size(), false),
        distance_(patch.vertices.size(), std::numeric_limits<double>::infinity()) {}

  void place_all(std::uint32_t seed) {
    place_from(seed);
    for (std::uint32_t v = 0; v < placed_.size(); ++v) {
      if (!placed_[v]) place_from(v);
    }
  }

 private:
  glm::dvec3 position(std::uint32_t v) const { return glm::dvec3(mesh_.positions[patch_.vertices[v]]); }
  glm::dvec3 normal(std::uint32_t v) const { return glm::dvec3(mesh_.normals[patch_.vertices[v]]); }
  glm::dvec3 tangent(std::uint32_t v) const { return glm::dvec3(mesh_.tangents[patch_.vertices[v]]); }

  void place_from(std::uint32_t seed) {
    std::priority_queue<std::pair<double, std::uint32_t>, std::vector<std::pair<double, std::uint32_t>>, std::greater<>>
        front;
    distance_[seed] = 0;
    front.emplace(0.0, seed);
    while (!front.empty()) {
      const auto [so_far, v] = front.top();
      front.pop();
      if (placed_[v]) continue;
      predict(v);
      placed_[v] = true;
      for (const std::uint32_t next : neighbours_.of(v)) {
        const double reached = so_far + glm::distance(position(v), position(next));
        if (!(reached < distance_[next])) continue;
        distance_[next] = reached;
        front.emplace(reached, next);
      }
    }
  }

  /// Places a vertex at the mean of the predictions of its placed neighbours, with larger weights for nearer ones; the
  /// seed, which has none, stays at the origin.
  void predict(std::uint32_t v) {
    glm::dvec2 uv_sum(0), heading(0);
    double weights = 0;
    for (const std::uint32_t from : neighbours_.of(v)) {
      if (!placed_[from]) continue;
      const double weight = 1 / std::max(glm::distance(position(v), position(from)), 1e-12);
      uv_sum += weight * (patch_.uv[from] + step(from, v));
      heading += weight * rotated({1, 0}, tangent_angles_[from] - transport_angle(from, v));
      weights += weight;
    }
    if (!(weights > 0)) return;
    patch_.uv[v] = uv_sum / weights;
    tangent_angles_[v] = std::atan2(heading.y, heading.x);
  }

  /// Returns the edge projected to the tangent plane of its start, at its full length, in the plane of the map.
  glm::dvec2 step(std::uint32_t from, std::uint32_t to) const {
    const glm::dvec3 edge = position(to) - position(from), t = tangent(from);
    const glm::dvec2 flat(glm::dot(edge, t), glm::dot(edge, glm::cross(normal(from), t)));
    const double length = glm::length(flat);
    if (!(length > 0)) return glm::dvec2(0);
    return rotated(flat * (glm::length(edge) / length), tangent_angles_[from]);
  }

  /// Returns the angle of the tangent of `from`, transported along the edge, in the frame of `to`.
  double transport_angle(std::uint32_t from, std::uint32_t to) const {
    const glm::dvec3 brought = transported(tangent(from), normal(from), normal(to));
    return std::atan2(glm::dot(brought, glm::cross(normal(to), tangent(to))), glm::dot(brought, tangent(to)));
  }

  const Mesh& mesh_;
  FlatPatch& patch_;
  const Adjacency& neighbours_;
  std::vector<double> tangent_angles_;  // for each vertex: angle of its tangent on the map
  std::vector<bool> placed_;
  std::vector<double> distance_;
};

/// A triangle in its own plane, with the weight of the side from each corner to the next.
struct FlatTriangle {
  std::array<glm::dvec2, 3> corners;
  std::array<double, 3> weights;
};

std::array<glm::dvec3, 3> corners_of(const Mesh& mesh, const FlatPatch& patch, const glm::uvec3& t) {
  const auto at = [&](std::uint32_t v) { return glm::dvec3(mesh.positions[patch.vertices[v]]); };
  return {at(t.x), at(t.y), at(t.z)};
}

std::array<glm::dvec2, 3> uv_of(const FlatPatch& patch, const glm::uvec3& t) {
  return {patch.uv[t.x], patch.uv[t.y], patch.uv[t.z]};
}

FlatTriangle unfolded(const std::array<glm::dvec3, 3>& p) {
  const glm::dvec3 a = p[1] - p[0], b = p[2] - p[0];
  const double length = glm::length(a), area = glm::length(glm::cross(a, b));
  FlatTriangle flat;
  flat.corners = {glm::dvec2(0), glm::dvec2(length, 0),
                  length > 0 ? glm::dvec2(glm::dot(a, b), area) / length : glm::dvec2(0, glm::length(b))};
  for (std::size_t k = 0; k < 3; ++k) {
    // Half the cotangent of the angle opposite to the side, kept positive so that the system stays definite.
    const glm::dvec3 u = p[k] - p[(k + 2) % 3], v = p[(k + 1) % 3] - p[(k + 2) % 3];
    const double cosine = glm::dot(u, v);
    flat.weights[k] = area > 0 ? 0.5 * std::clamp(cosine / area, 0.05, 20.0) : 0.5;
  }
  return flat;
}

/// Alternates between the best rotation of each triangle and the positions that fit all of them best.
class RigidFit {
 public:
  RigidFit(const Mesh& mesh, FlatPatch& patch) : patch_(patch) {
    std::vector<Eigen::Triplet<double>> entries;
    for (const glm::uvec3& t : patch.triangles) {
      flat_.push_back(unfolded(corners_of(mesh, patch, t)));
      for (int k = 0; k < 3; ++k) {
        const auto i = static_cast<int>(t[k]), j = static_cast<int>(t[(k + 1) % 3]);
        const double w = flat_.back().weights[static_cast<std::size_t>(k)];
        entries.insert(entries.end(), {{i, i, w}, {j, j, w}, {std::max(i, j), std::min(i, j), -w}});
      }
    }
    const auto n = static_cast<int>(patch.vertices.size());
    // Without this anchor the positions are free to drift, and parts that touch nowhere make the system singular.
    for (int i = 0; i < n; ++i) entries.emplace_back(i, i, anchor);
    Eigen::SparseMatrix<double> matrix(n, n);
    matrix.setFromTriplets(entries.begin(), entries.end());
    solver_.compute(matrix);
  }

  bool solvable() const { return solver_.info() == Eigen::Success; }

  void iterate() {
    const auto n = static_cast<Eigen::Index>(patch_.vertices.size());
    Eigen::MatrixX2d right(n, 2);
    for (Eigen::Index i = 0; i < n; ++i) {
      const glm::dvec2 uv = anchor * patch_.uv[static_cast<std::size_t>(i)];
      right.row(i) << uv.x, uv.y;
    }
    for (std::size_t t = 0; t < flat_.size(); ++t) add_targets(t, right);
    const Eigen::MatrixX2d solution = solver_.solve(right);
    if (!solution.allFinite()) return;
    for (Eigen::Index i = 0; i < n; ++i) patch_.uv[static_cast<std::size_t>(i)] = {solution(i, 0), solution(i, 1)};
  }

 private:
  static constexpr double anchor = 1e-7;

  /// Adds the target differences of positions to the right-hand side: the sides of triangle t, rotated as the map
  /// rotates the triangle.
  void add_targets(std::size_t t, Eigen::MatrixX2d& right) const {
    const FlatTriangle& flat = flat_[t];
    const glm::uvec3& v = patch_.triangles[t];
    double cosine = 0, sine = 0;
    for (std::size_t k = 0; k < 3; ++k) {
      const int a = static_cast<int>(k), b = static_cast<int>((k + 1) % 3);
      const glm::dvec2 x = flat.corners[(k + 1) % 3] - flat.corners[k], u = patch_.uv[v[b]] - patch_.uv[v[a]];
      cosine += flat.weights[k] * (u.x * x.x + u.y * x.y);
      sine += flat.weights[k] * (u.y * x.x - u.x * x.y);
    }
    const double length = std::hypot(cosine, sine);
    const double c = length > 0 ? cosine / length : 1, s = length > 0 ? sine / length : 0;
    for (std::size_t k = 0; k < 3; ++k) {
      const glm::dvec2 side = flat.weights[k] * (flat.corners[(k + 1) % 3] - flat.corners[k]);
      const Eigen::RowVector2d row(c * side.x - s * side.y, s * side.x + c * side.y);
      right.row(v[static_cast<int>((k + 1) % 3)]) += row;
      right.row(v[static_cast<int>(k)]) -= row;
    }
  }

  FlatPatch& patch_;
  std::vector<FlatTriangle> flat_;
  Eigen::SimplicialLDLT<Eigen::SparseMatrix<double>> solver_;
};

/// Returns whether no triangle is stretched by more than this share.
bool is_rigid(const Mesh& mesh, const FlatPatch& patch, double share) {
  return std::all_of(patch.triangles.begin(), patch.triangles.end(), [&](const glm::uvec3& t) {
    const Stretch s = stretch_of(corners_of(mesh, patch, t), uv_of(patch, t));
    return !s.flipped && s.large < 1 + share && s.small > 1 - share;
  });
}

/// Returns whether there are no more edges than a surface can have (three for each vertex, Euler). Triangles that meet
/// at random have more, and their system would fill up and take minutes.
bool is_like_a_surface(const Adjacency& neighbours) {
  const double edges = 0.5 * static_cast<double>(neighbours.others.size());
  return edges <= 3.2 * static_cast<double>(neighbours.begin.size() - 1);
}

/// Scales the patch to the area of its triangles, and rotates it so that the mean tangent points along u.
void align(const Mesh& mesh, FlatPatch& patch) {
  double area = 0, flat_area = 0;
  glm::dvec2 heading(0);
  for (const glm::uvec3& t : patch.triangles) {
    const auto p = corners_of(mesh, patch, t);
    const auto uv = uv_of(patch, t);
    const glm::dvec3 e1 = p[1] - p[0], e2 = p[2] - p[0], n = glm::cross(e1, e2);
    const glm::dvec2 d1 = uv[1] - uv[0], d2 = uv[2] - uv[0];
    const double twice = glm::length(n);
    if (!(twice > 0)) continue;
    area += twice;
    flat_area += d1.x * d2.y - d1.y * d2.x;
    glm::dvec3 tangent(0);
    for (int k = 0; k < 3; ++k) tangent += glm::dvec3(mesh.tangents[patch.vertices[t[k]]]);
    // The tangent as a e1 + b e2, in the least-squares sense of the triangle's plane.
    const double a = glm::dot(glm::cross(tangent, e2), n) / twice, b = glm::dot(glm::cross(e1, tangent), n) / twice;
    heading += a * d1 + b * d2;
  }
  const double scale = area > 0 && flat_area > 0 ? std::clamp(std::sqrt(area / flat_area), 0.8, 1.25) : 1;
  const double angle = glm::length(heading) > 1e-9 * area ? -std::atan2(heading.y, heading.x) : 0;
  for (glm::dvec2& uv : patch.uv) uv = scale * rotated(uv, angle);
}

/// Returns the index in the patch of a vertex of the mesh.
std::uint32_t index_of(const FlatPatch& patch, std::uint32_t vertex) {
  const auto found = std::lower_bound(patch.vertices.begin(), patch.vertices.end(), vertex);
  return static_cast<std::uint32_t>(found - patch.vertices.begin());
}

/// Returns the triangles with their vertices as a patch, with all positions at the origin.
FlatPatch unplaced_patch(const Mesh& mesh, std::span<const std::uint32_t> triangles) {
  FlatPatch patch;
  for (const std::uint32_t t : triangles) {
    for (int k = 0; k < 3; ++k) patch.vertices.push_back(mesh.triangles[t][k]);
  }
  std::sort(patch.vertices.begin(), patch.vertices.end());
  patch.vertices.erase(std::unique(patch.vertices.begin(), patch.vertices.end()), patch.vertices.end());
  for (const std::uint32_t t : triangles) {
    const glm::uvec3& v = mesh.triangles[t];
    patch.triangles.emplace_back(index_of(patch, v.x), index_of(patch, v.y), index_of(patch, v.z));
  }
  patch.uv.assign(patch.vertices.size(), glm::dvec2(0));
  return patch;
}

}  // namespace

FlatPatch flatten(const Mesh& mesh, std::span<const std::uint32_t> triangles, std::uint32_t seed) {
  constexpr int iterations = 12;
  constexpr double rigid = 0.002;
  FlatPatch patch = unplaced_patch(mesh, triangles);
  const Adjacency neighbours = vertex_neighbours(patch.triangles, patch.vertices.size());
  ExponentialMap(mesh, neighbours, patch).place_all(index_of(patch, seed));
  if (is_like_a_surface(neighbours) && !is_rigid(mesh, patch, rigid)) {
    RigidFit fit(mesh, patch);
    for (int i = 0; fit.solvable() && i < iterations; ++i) fit.iterate();
  }
  align(mesh, patch);
  return patch;
}

Stretch stretch_of(const std::array<glm::dvec3, 3>& p, const std::array<glm::dvec2, 3>& uv) {
  const glm::dvec3 e1 = p[1] - p[0], e2 = p[2] - p[0];
  const double length = glm::length(e1), twice = glm::length(glm::cross(e1, e2));
  // The shape of thinner triangles would depend on the rounding of 32-bit positions.
  if (!(twice > 1e-7 * std::max(glm::dot(e1, e1), glm::dot(e2, e2)))) return {};
  const double x2 = glm::dot(e1, e2) / length, y2 = twice / length;
  const glm::dvec2 du = (uv[1] - uv[0]) / length, dv = ((uv[2] - uv[0]) - du * x2) / y2;
  const double sum = glm::dot(du, du) + glm::dot(dv, dv), determinant = du.x * dv.y - du.y * dv.x;
  const double gap = std::sqrt(std::max(0.0, sum * sum - 4 * determinant * determinant));
  const double large = std::sqrt((sum + gap) / 2);
  return {large, large > 0 ? std::abs(determinant) / large : 0, determinant < 0};
}

}  // namespace pelage
