#include "server/fields/field_set.h"

namespace pelage {

namespace {

/// Where the coat lies on most animals: from nose to tail, and a little down. Unit.
glm::dvec3 tailwards() { return glm::normalize(glm::dvec3(0, -0.35, -1)); }

}  // namespace

FieldSet first_groom(const Mesh& mesh, const FirstGroom& fur) {
  constexpr double vanishing = 0.05;  // nose and rump: there the surface part has no steady heading
  FieldSet fields(mesh.positions.size());
  for (std::uint32_t v = 0; v < mesh.positions.size(); ++v) {
    const glm::dvec3 normal(mesh.normals[v]), tangent(mesh.tangents[v]);
    const glm::dvec2 lie(glm::dot(tailwards(), tangent), glm::dot(tailwards(), glm::cross(normal, tangent)));
    const double along = glm::length(lie);
    const glm::dvec2 heading = along > vanishing ? lie / along : glm::dvec2(1, 0);
    const double scale = mesh.length_scale.empty() ? 1.0 : double{mesh.length_scale[v]};
    fields.set(v, stored_groom(fur.inclination * heading, fur.length * scale, 0));
  }
  return fields;
}

}  // namespace pelage
