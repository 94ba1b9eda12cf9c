#include "server/groom/first_groom.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include "server/groom/fur_flow.h"
#include "server/surface/materials.h"

namespace pelage {

namespace {

double smoothstep(double low, double high, double x) {
  const double t = std::clamp((x - low) / (high - low), 0.0, 1.0);
  return t * t * (3 - 2 * t);
}

/// The relative length of an animal's fur by position, for an animal in the mesh's box that faces +Z. Factors are in
/// [.4, 1.4].
class AnimalLengths {
 public:
  explicit AnimalLengths(const Mesh& mesh) : low_(mesh.to_internal(mesh.report.bounds.min)) {
    extent_ = glm::max(mesh.to_internal(mesh.report.bounds.max) - low_, 1e-9);
  }

  double at(glm::dvec3 position, glm::dvec3 normal) const {
    const glm::dvec3 share = (position - low_) / extent_;
    const double face = smoothstep(0.7, 0.88, share.z) * smoothstep(0.45, 0.6, share.y);
    const double paws = 1 - smoothstep(0.05, 0.18, share.y);
    const double chest = smoothstep(0.2, 0.6, normal.z) * smoothstep(0.3, 0.45, share.y) *
                         (1 - smoothstep(0.55, 0.7, share.y)) * (1 - face);
    const double tail = (1 - smoothstep(0.05, 0.2, share.z)) * (1 - paws);
    return (1 - 0.6 * face) * (1 - 0.5 * paws) * (1 + 0.4 * chest) * (1 + 0.3 * tail);
  }

 private:
  glm::dvec3 low_, extent_;
};

/// Limits the lean of fur at a vertex on a crease, so that the strand does not enter the surface on a side of the
/// crease.
class EdgeLimits {
 public:
  explicit EdgeLimits(const Mesh& mesh) : mesh_(mesh), sides_(mesh.shading_normals.empty() ? 0 : mesh.normals.size()) {
    for (std::size_t t = 0; t < mesh.shading_normals.size(); ++t) {
      for (std::size_t k = 0; k < 3; ++k) {
        const std::uint32_t v = mesh.triangles[t][static_cast<int>(k)];
        if (mesh.shading_normals[t][k] != mesh.normals[v]) sides_[v].push_back(glm::dvec3(mesh.shading_normals[t][k]));
      }
    }
  }

  /// Returns the inclination, reduced as far as needed. `heading` is a unit vector in the vertex's frame.
  double limited(std::uint32_t v, glm::dvec2 heading, double inclination) const {
    constexpr double rising = 0.3, step = 0.05;
    if (sides_.empty() || sides_[v].empty()) return inclination;
    const glm::dvec3 normal(mesh_.normals[v]), tangent(mesh_.tangents[v]);
    const glm::dvec3 lean = heading.x * tangent + heading.y * glm::cross(normal, tangent);
    const auto rises = [&](double share) {
      const double angle = share * glm::radians(90.0);
      const glm::dvec3 strand = std::cos(angle) * normal + std::sin(angle) * lean;
      return std::all_of(sides_[v].begin(), sides_[v].end(), [&](const glm::dvec3& side) {
        return glm::dot(strand, side) >= std::min(rising, glm::dot(normal, side));
      });
    };
    while (inclination > 0 && !rises(inclination)) inclination = std::max(0.0, inclination - step);
    return inclination;
  }

 private:
  const Mesh& mesh_;
  std::vector<std::vector<glm::dvec3>> sides_;
};

}  // namespace

FieldSet first_groom(const Mesh& mesh, const FirstGroom& fur, const Cancel& cancel) {
  constexpr double clear = 0.6;  // length of the flow at and above which fur has the full inclination
  FieldSet fields(mesh.positions.size());
  const AnimalLengths animal(mesh);
  const EdgeLimits edges(mesh);
  const std::vector<bool> bare = bare_vertices(mesh);
  const std::vector<glm::dvec2> flow = fur_flow(mesh, cancel);
  for (std::uint32_t v = 0; v < mesh.positions.size(); ++v) {
    const glm::dvec3 normal(mesh.normals[v]);
    const double along = glm::length(flow[v]);
    const glm::dvec2 heading = along > 0 ? flow[v] / along : glm::dvec2(0);
    const double inclination = edges.limited(v, heading, fur.inclination * smoothstep(0, clear, along));
    double scale = mesh.length_scale.empty() ? 1.0 : double{mesh.length_scale[v]};
    if (fur.form == GroomForm::animal) scale *= animal.at(glm::dvec3(mesh.positions[v]), normal);
    fields.set(v, stored_groom(inclination * heading, fur.length * scale, 0));
    if (bare[v]) fields.set(Field::bare, v, glm::vec4(1, 0, 0, 0));
  }
  return fields;
}

}  // namespace pelage
