#include "server/groom/fur_flow.h"

#include <Eigen/IterativeLinearSolvers>
#include <Eigen/SparseCholesky>
#include <algorithm>
#include <complex>
#include <numeric>

#include "server/groom/poles.h"
#include "server/groom/two_level.h"
#include "server/surface/adjacency.h"
#include "server/surface/geodesics.h"

namespace pelage {

namespace {

using Complex = std::complex<double>;

/// Returns the direction of the coat on most animals: from nose to tail, and a little down. Unit.
glm::dvec3 default_coat_direction() { return glm::normalize(glm::dvec3(0, -0.35, -1)); }

glm::dvec3 position_of(const Mesh& mesh, std::uint32_t v) { return glm::dvec3(mesh.positions[v]); }
glm::dvec3 normal_of(const Mesh& mesh, std::uint32_t v) { return glm::dvec3(mesh.normals[v]); }

/// An edge between two vertices, with its coupling weight.
struct Edge {
  std::uint32_t a, b;
  double weight;
};

/// Returns cotangent weights, clamped to positive values so that solutions have no spurious extrema.
std::vector<Edge> weighted_edges(const Mesh& mesh) {
  constexpr double weakest = 0.02, strongest = 50;
  std::vector<Edge> edges;
  for_each_edge(sorted_sides(mesh.triangles), [&](std::span<const Side> edge) {
    double weight = 0;
    for (const Side& side : edge) {
      const glm::uvec3 t = mesh.triangles[side.triangle];
      const std::uint32_t opposite = t[static_cast<int>((side.side + 2) % 3)];
      const glm::dvec3 u = position_of(mesh, side.low) - position_of(mesh, opposite),
                       v = position_of(mesh, side.high) - position_of(mesh, opposite);
      const double sine = glm::length(glm::cross(u, v));
      if (sine > 0) weight += 0.5 * glm::dot(u, v) / sine;
    }
    edges.push_back({edge[0].low, edge[0].high, std::clamp(weight, weakest, strongest)});
  });
  return edges;
}

/// Returns for each vertex a third of the area of its triangles.
std::vector<double> vertex_areas(const Mesh& mesh) {
  std::vector<double> areas(mesh.positions.size(), 0);
  for (const glm::uvec3& t : mesh.triangles) {
    const glm::dvec3 a = position_of(mesh, t.x);
    const double third = glm::length(glm::cross(position_of(mesh, t.y) - a, position_of(mesh, t.z) - a)) / 6;
    for (int k = 0; k < 3; ++k) areas[t[k]] += third;
  }
  return areas;
}

/// Solves a Hermitian positive definite system, directly if it is small, else iteratively. Throws Cancelled.
template <class Number>
Eigen::Matrix<Number, Eigen::Dynamic, 1> solved(const Eigen::SparseMatrix<Number>& matrix,
                                                const Eigen::Matrix<Number, Eigen::Dynamic, 1>& right,
                                                const Cancel& cancel) {
  constexpr Eigen::Index small = 60'000;
  cancel.check();
  if (matrix.rows() <= small) return Eigen::SimplicialLDLT<Eigen::SparseMatrix<Number>>(matrix).solve(right);
  Eigen::ConjugateGradient<Eigen::SparseMatrix<Number>, Eigen::Lower | Eigen::Upper, TwoLevel<Number>> solver;
  solver.preconditioner().set_cancel(cancel);
  solver.setTolerance(1e-4);
  solver.setMaxIterations(2'000);
  return solver.compute(matrix).solve(right);
}

/// Returns the parts that are connected by edges, each with its vertices sorted.
std::vector<std::vector<std::uint32_t>> parts_of(const Adjacency& edges, std::size_t vertices) {
  std::vector<std::vector<std::uint32_t>> parts;
  std::vector<bool> seen(vertices, false);
  for (std::uint32_t seed = 0; seed < vertices; ++seed) {
    if (seen[seed]) continue;
    std::vector<std::uint32_t> part{seed};
    seen[seed] = true;
    for (std::size_t i = 0; i < part.size(); ++i) {
      for (const std::uint32_t other : edges.of(part[i])) {
        if (!seen[other]) seen[other] = true, part.push_back(other);
      }
    }
    std::sort(part.begin(), part.end());
    parts.push_back(std::move(part));
  }
  return parts;
}

/// Classifies the parts of a mesh: closed bodies, and bodies with handles.
class Closure {
 public:
  Closure(const Mesh& mesh, const std::vector<std::vector<std::uint32_t>>& parts)
      : part_of_(mesh.positions.size()),
        sums_(parts.size(), glm::dvec3(0)),
        areas_(parts.size(), 0),
        characteristic_(parts.size()),
        open_edges_(parts.size(), 0) {
    for (std::uint32_t p = 0; p < parts.size(); ++p) {
      characteristic_[p] = static_cast<long>(parts[p].size());
      for (const std::uint32_t v : parts[p]) part_of_[v] = p;
    }
    for (const glm::uvec3& t : mesh.triangles) add(mesh, t);
    for_each_edge(sorted_sides(mesh.triangles), [&](std::span<const Side> edge) {
      const std::uint32_t p = part_of_[edge[0].low];
      --characteristic_[p];
      if (edge.size() == 1) ++open_edges_[p];
    });
  }

  /// Returns whether the part encloses a volume, apart from holes that are small compared to it.
  bool is_body(std::size_t part) const {
    constexpr double mostly = 0.25;
    return glm::length(sums_[part]) < mostly * areas_[part];
  }
  /// Returns whether the part has no open edges and at least one handle (Euler characteristic below 2).
  bool has_handles(std::size_t part) const { return open_edges_[part] == 0 && characteristic_[part] < 2; }

 private:
  void add(const Mesh& mesh, const glm::uvec3& t) {
    const glm::dvec3 a = position_of(mesh, t.x);
    const glm::dvec3 vector = glm::cross(position_of(mesh, t.y) - a, position_of(mesh, t.z) - a);
    const std::uint32_t p = part_of_[t.x];
    sums_[p] += vector, areas_[p] += glm::length(vector), ++characteristic_[p];
  }

  std::vector<std::uint32_t> part_of_;
  std::vector<glm::dvec3> sums_;  // sum of each part's area vectors, which is 0 for a closed surface
  std::vector<double> areas_;
  std::vector<long> characteristic_;  // Euler characteristic
  std::vector<std::size_t> open_edges_;
};

/// Returns the potential of the poles: its negative gradient flows from the poles above 0 to the others.
Eigen::VectorXd potential_of(const std::vector<Edge>& edges, const std::vector<Pole>& poles, std::size_t vertices,
                             const Cancel& cancel) {
  constexpr double anchored = 1e-7;  // relative to the coupling; fixes the free constant, and parts without poles
  const auto n = static_cast<Eigen::Index>(vertices);
  std::vector<Eigen::Triplet<double>> entries;
  for (const Edge& e : edges) {
    const auto a = static_cast<int>(e.a), b = static_cast<int>(e.b);
    entries.emplace_back(a, b, -e.weight), entries.emplace_back(b, a, -e.weight);
    entries.emplace_back(a, a, e.weight * (1 + anchored)), entries.emplace_back(b, b, e.weight * (1 + anchored));
  }
  Eigen::SparseMatrix<double> matrix(n, n);
  matrix.setFromTriplets(entries.begin(), entries.end());
  Eigen::VectorXd flux = Eigen::VectorXd::Zero(n);
  for (const Pole& pole : poles) flux[pole.vertex] += pole.flux;
  return solved<double>(matrix, flux, cancel);
}

/// Returns the negative gradient at each vertex: the area-weighted mean over its triangles.
std::vector<glm::dvec3> downhill(const Mesh& mesh, const Eigen::VectorXd& potential) {
  std::vector<glm::dvec3> flow(mesh.positions.size(), glm::dvec3(0));
  for (const glm::uvec3& t : mesh.triangles) {
    const glm::dvec3 a = position_of(mesh, t.x), b = position_of(mesh, t.y), c = position_of(mesh, t.z);
    const glm::dvec3 normal = glm::cross(b - a, c - a);
    const double area = glm::length(normal);
    if (!(area > 0)) continue;
    const glm::dvec3 slope = (potential[t.x] * glm::cross(normal, c - b) + potential[t.y] * glm::cross(normal, a - c) +
                              potential[t.z] * glm::cross(normal, b - a)) /
                             area;  // gradient times twice the area
    for (int k = 0; k < 3; ++k) flow[t[k]] -= slope;
  }
  return flow;
}

Complex in_frame(const Mesh& mesh, std::uint32_t v, glm::dvec3 vector) {
  const glm::dvec3 tangent(mesh.tangents[v]);
  return {glm::dot(vector, tangent), glm::dot(vector, glm::cross(normal_of(mesh, v), tangent))};
}

/// Returns the rotation that transports a vector from the frame of `from` to the frame of `to`, as a unit complex
/// number.
Complex frame_transport(const Mesh& mesh, std::uint32_t from, std::uint32_t to) {
  const Complex there =
      in_frame(mesh, to, transported(glm::dvec3(mesh.tangents[from]), normal_of(mesh, from), normal_of(mesh, to)));
  const double length = std::abs(there);
  return length > 0 ? there / length : Complex(1, 0);
}

/// The target flow at each vertex, of length at most 1, and the distance in sizes over which it is smoothed.
struct TargetFlow {
  std::vector<Complex> flow;
  std::vector<double> spread;
  std::vector<std::vector<std::uint32_t>> parts;
};

TargetFlow target_flow(const Mesh& mesh, const std::vector<Edge>& edges, const Cancel& cancel) {
  const Adjacency neighbours = vertex_neighbours(mesh.triangles, mesh.positions.size());
  const std::vector<std::vector<std::uint32_t>> parts = parts_of(neighbours, mesh.positions.size());
  const Closure closure(mesh, parts);
  PoleFinder finder(mesh, neighbours, cancel);
  std::vector<Pole> poles;
  std::vector<bool> by_poles(mesh.positions.size(), false);
  for (std::size_t p = 0; p < parts.size(); ++p) {
    if (!closure.is_body(p) || closure.has_handles(p)) continue;
    const std::vector<Pole> found = finder.find(parts[p]);
    poles.insert(poles.end(), found.begin(), found.end());
    for (const std::uint32_t v : parts[p]) by_poles[v] = !found.empty();
  }
  const std::vector<glm::dvec3> flow = poles.empty()
                                           ? std::vector<glm::dvec3>(mesh.positions.size(), glm::dvec3(0))
                                           : downhill(mesh, potential_of(edges, poles, mesh.positions.size(), cancel));
  constexpr double fine = 0.08, coarse = 0.5;  // sizes; without poles the target has many sources, which have to cancel
  TargetFlow targets{{}, {}, parts};
  for (std::uint32_t v = 0; v < mesh.positions.size(); ++v) {
    Complex target = in_frame(mesh, v, by_poles[v] ? flow[v] : default_coat_direction());
    if (by_poles[v] && std::abs(target) > 0) target /= std::abs(target);
    targets.flow.push_back(target), targets.spread.push_back(by_poles[v] ? fine : coarse);
  }
  return targets;
}

/// Divides each part's flow by its median length and limits it to 1. Where targets oppose each other it is short, but
/// its direction is still clear.
std::vector<glm::dvec2> relative(const Eigen::VectorXcd& smooth, const std::vector<std::vector<std::uint32_t>>& parts) {
  std::vector<glm::dvec2> flow(static_cast<std::size_t>(smooth.size()), glm::dvec2(0));
  for (const std::vector<std::uint32_t>& part : parts) {
    std::vector<double> lengths;
    for (const std::uint32_t v : part) lengths.push_back(std::isfinite(std::abs(smooth[v])) ? std::abs(smooth[v]) : 0);
    const auto middle = lengths.begin() + static_cast<std::ptrdiff_t>(lengths.size() / 2);
    std::nth_element(lengths.begin(), middle, lengths.end());
    for (const std::uint32_t v : part) {
      const double length = std::abs(smooth[v]), longest = std::max(length, *middle);
      if (std::isfinite(length) && longest > 0) flow[v] = {smooth[v].real() / longest, smooth[v].imag() / longest};
    }
  }
  return flow;
}

}  // namespace

std::vector<glm::dvec2> fur_flow(const Mesh& mesh, const Cancel& cancel) {
  const std::vector<Edge> edges = weighted_edges(mesh);
  const TargetFlow targets = target_flow(mesh, edges, cancel);
  const std::vector<double> areas = vertex_areas(mesh);
  const auto n = static_cast<Eigen::Index>(mesh.positions.size());
  std::vector<Eigen::Triplet<Complex>> entries;
  Eigen::VectorXcd right(n);
  for (std::uint32_t v = 0; v < mesh.positions.size(); ++v) {
    const double pull = std::max(areas[v], 1e-12) / (targets.spread[v] * targets.spread[v]);
    entries.emplace_back(static_cast<int>(v), static_cast<int>(v), pull);
    right[v] = pull * targets.flow[v];
  }
  for (const Edge& e : edges) {
    const auto a = static_cast<int>(e.a), b = static_cast<int>(e.b);
    const Complex transport = frame_transport(mesh, e.a, e.b);
    entries.emplace_back(a, a, e.weight), entries.emplace_back(b, b, e.weight);
    entries.emplace_back(b, a, -e.weight * transport), entries.emplace_back(a, b, -e.weight * std::conj(transport));
  }
  Eigen::SparseMatrix<Complex> matrix(n, n);
  matrix.setFromTriplets(entries.begin(), entries.end());
  const Eigen::VectorXcd smooth = solved<Complex>(matrix, right, cancel);
  return relative(smooth, targets.parts);
}

}  // namespace pelage
