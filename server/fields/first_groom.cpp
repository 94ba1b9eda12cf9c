#include <algorithm>

#include "server/fields/field_set.h"

namespace pelage {

namespace {

/// Where the coat lies on most animals: from nose to tail, and a little down. Unit.
glm::dvec3 tailwards() { return glm::normalize(glm::dvec3(0, -0.35, -1)); }

double smoothstep(double low, double high, double x) {
  const double t = std::clamp((x - low) / (high - low), 0.0, 1.0);
  return t * t * (3 - 2 * t);
}

/// How long fur is on an animal in this box that looks along +Z, over the length that was asked for, in [.4, 1.4].
class AnimalLengths {
 public:
  explicit AnimalLengths(const Mesh& mesh) : low_(mesh.to_internal(mesh.report.min)) {
    extent_ = glm::max(mesh.to_internal(mesh.report.max) - low_, 1e-9);
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

}  // namespace

FieldSet first_groom(const Mesh& mesh, const FirstGroom& fur) {
  // Nose and rump are the field's two singular points: there fur stands up, or strands would lie in a whorl.
  constexpr double lying = 0.35;
  FieldSet fields(mesh.positions.size());
  const AnimalLengths animal(mesh);
  for (std::uint32_t v = 0; v < mesh.positions.size(); ++v) {
    const glm::dvec3 normal(mesh.normals[v]), tangent(mesh.tangents[v]);
    const glm::dvec2 lie(glm::dot(tailwards(), tangent), glm::dot(tailwards(), glm::cross(normal, tangent)));
    const double along = glm::length(lie);
    const glm::dvec2 heading = along > 0 ? lie / along : glm::dvec2(0);
    const double inclination = fur.inclination * smoothstep(0, lying, along);
    double scale = mesh.length_scale.empty() ? 1.0 : double{mesh.length_scale[v]};
    if (fur.form == GroomForm::animal) scale *= animal.at(glm::dvec3(mesh.positions[v]), normal);
    fields.set(v, stored_groom(inclination * heading, fur.length * scale, 0));
  }
  return fields;
}

}  // namespace pelage
