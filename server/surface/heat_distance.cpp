#include "server/surface/heat_distance.h"

#include <Eigen/Sparse>
#include <Eigen/SparseCholesky>
#include <algorithm>
#include <cmath>
#include <limits>

namespace pelage {

namespace {

using Matrix = Eigen::SparseMatrix<double>;
using Vector = Eigen::VectorXd;

/// Heat falls like exp(-distance / reach): shorter, and it would leave the range of double on the far side.
constexpr double min_reach = 1.0 / 200;
/// Of the smaller of two matrices' diagonals; makes the Laplacian of every connected part invertible.
constexpr double regularisation = 1e-9;

/// A triangle's corners, its area, and the gradients of its corners' hat functions.
struct Element {
  glm::uvec3 corners{0};
  double area = 0;
  glm::dvec3 gradients[3] = {};
};

std::vector<Element> elements_of(const Mesh& mesh) {
  std::vector<Element> elements;
  elements.reserve(mesh.triangles.size());
  for (const glm::uvec3& corners : mesh.triangles) {
    const glm::dvec3 p[3] = {glm::dvec3(mesh.positions[corners.x]), glm::dvec3(mesh.positions[corners.y]),
                             glm::dvec3(mesh.positions[corners.z])};
    const glm::dvec3 cross = glm::cross(p[1] - p[0], p[2] - p[0]);
    const double twice = glm::length(cross);
    const double longest = std::max({glm::distance(p[0], p[1]), glm::distance(p[1], p[2]), glm::distance(p[2], p[0])});
    constexpr double thinnest = 1e-8;  // height over longest side
    if (!(twice > thinnest * longest * longest)) continue;
    Element element{corners, twice / 2, {}};
    for (int k = 0; k < 3; ++k)
      element.gradients[k] = glm::cross(cross / twice, p[(k + 2) % 3] - p[(k + 1) % 3]) / twice;
    elements.push_back(element);
  }
  return elements;
}

/// Of all sides of all triangles, so that the order of corners does not matter.
double mean_edge(const Mesh& mesh) {
  double sum = 0;
  for (const glm::uvec3& t : mesh.triangles) {
    for (int k = 0; k < 3; ++k) sum += glm::distance(mesh.positions[t[k]], mesh.positions[t[(k + 1) % 3]]);
  }
  return mesh.triangles.empty() ? 1 : sum / (3.0 * static_cast<double>(mesh.triangles.size()));
}

/// Each vertex's connected part.
std::vector<std::uint32_t> parts_of(const Surface& surface) {
  constexpr auto unknown = std::numeric_limits<std::uint32_t>::max();
  std::vector<std::uint32_t> parts(surface.mesh().positions.size(), unknown), front;
  std::uint32_t count = 0;
  for (std::uint32_t first = 0; first < parts.size(); ++first) {
    if (parts[first] != unknown) continue;
    parts[first] = count, front.push_back(first);
    while (!front.empty()) {
      const std::uint32_t v = front.back();
      front.pop_back();
      for (const std::uint32_t next : surface.neighbours(v)) {
        if (parts[next] == unknown) parts[next] = count, front.push_back(next);
      }
    }
    ++count;
  }
  return parts;
}

}  // namespace

struct HeatDistance::Impl {
  std::vector<Element> elements;
  std::vector<std::uint32_t> parts;
  Eigen::SimplicialLDLT<Matrix> flow, laplacian;

  explicit Impl(const Surface& surface);
  Vector divergence(const Vector& heat) const;
};

HeatDistance::Impl::Impl(const Surface& surface) : elements(elements_of(surface.mesh())), parts(parts_of(surface)) {
  const auto size = static_cast<Eigen::Index>(surface.mesh().positions.size());
  const double reach = std::max(mean_edge(surface.mesh()), min_reach);
  std::vector<Eigen::Triplet<double>> stiffness, mass;
  for (const Element& element : elements) {
    for (int i = 0; i < 3; ++i) {
      mass.emplace_back(element.corners[i], element.corners[i], element.area / 3);
      for (int k = 0; k < 3; ++k)
        stiffness.emplace_back(element.corners[i], element.corners[k],
                               element.area * glm::dot(element.gradients[i], element.gradients[k]));
    }
  }
  for (Eigen::Index v = 0; v < size; ++v) {  // vertices of no triangle must not make the matrices singular
    mass.emplace_back(v, v, 1e-12);
    stiffness.emplace_back(v, v, regularisation);
  }
  Matrix masses(size, size), stiff(size, size);
  masses.setFromTriplets(mass.begin(), mass.end());
  stiff.setFromTriplets(stiffness.begin(), stiffness.end());
  flow.compute(masses + reach * reach * stiff);
  laplacian.compute(stiff);
}

/// Of the unit vectors against the heat's gradient.
Vector HeatDistance::Impl::divergence(const Vector& heat) const {
  Vector divergence = Vector::Zero(heat.size());
  for (const Element& element : elements) {
    glm::dvec3 gradient(0);
    for (int k = 0; k < 3; ++k) gradient += heat[element.corners[k]] * element.gradients[k];
    const double largest = std::max({std::abs(gradient.x), std::abs(gradient.y), std::abs(gradient.z)});
    if (!(largest > 0)) continue;
    const glm::dvec3 away = -glm::normalize(gradient / largest);
    for (int k = 0; k < 3; ++k) divergence[element.corners[k]] += element.area * glm::dot(element.gradients[k], away);
  }
  return divergence;
}

HeatDistance::HeatDistance(const Surface& surface) : impl_(std::make_unique<Impl>(surface)) {}
HeatDistance::~HeatDistance() = default;

std::vector<double> HeatDistance::operator()(std::span<const SpreadSource> sources) const {
  std::vector<double> distances(impl_->parts.size(), std::numeric_limits<double>::infinity());
  Vector heat = Vector::Zero(static_cast<Eigen::Index>(distances.size()));
  for (const SpreadSource& source : sources) heat[source.vertex] = 1;
  heat = impl_->flow.solve(heat);
  const Vector potential = impl_->laplacian.solve(impl_->divergence(heat));
  // The potential is known but for a constant on each part: there the sources are at their own distances.
  std::vector<double> offsets(distances.size(), std::numeric_limits<double>::infinity());
  for (const SpreadSource& source : sources) {
    double& offset = offsets[impl_->parts[source.vertex]];
    offset = std::min(offset, potential[source.vertex] - source.distance);
  }
  for (std::size_t v = 0; v < distances.size(); ++v)
    distances[v] = std::max(0.0, potential[static_cast<Eigen::Index>(v)] - offsets[impl_->parts[v]]);
  for (std::size_t v = 0; v < distances.size(); ++v) {
    if (!std::isfinite(offsets[impl_->parts[v]])) distances[v] = std::numeric_limits<double>::infinity();
  }
  for (const SpreadSource& source : sources)
    distances[source.vertex] = std::min(distances[source.vertex], source.distance);
  return distances;
}

}  // namespace pelage
