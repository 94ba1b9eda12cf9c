#include "server/patches/patch_points.h"

namespace pelage {

namespace {

/// The way in space in which u grows on the triangle, as long as twice its area; 0 where that is undefined.
glm::dvec3 u_axis(const Mesh& mesh, const FlatPatch& flat, const glm::uvec3& t) {
  const auto at = [&](int k) { return glm::dvec3(mesh.positions[flat.vertices[t[k]]]); };
  const glm::dvec3 e1 = at(1) - at(0), e2 = at(2) - at(0);
  const glm::dvec2 d1 = flat.uv[t.y] - flat.uv[t.x], d2 = flat.uv[t.z] - flat.uv[t.x];
  const double determinant = d1.x * d2.y - d1.y * d2.x;
  const glm::dvec3 along = (e1 * d2.y - e2 * d1.y) * (determinant < 0 ? -1.0 : 1.0);
  const double length = glm::length(along);
  return length > 0 ? along * (glm::length(glm::cross(e1, e2)) / length) : glm::dvec3(0);
}

}  // namespace

std::vector<PatchPoint> make_points(const Mesh& mesh, const FlatPatch& flat, std::uint32_t patch) {
  std::vector<glm::dvec3> axes(flat.vertices.size(), glm::dvec3(0));
  std::vector<double> areas(flat.vertices.size(), 0);
  for (const glm::uvec3& t : flat.triangles) {
    const glm::dvec3 axis = u_axis(mesh, flat, t);
    for (int k = 0; k < 3; ++k) axes[t[k]] += axis, areas[t[k]] += glm::length(axis);
  }
  std::vector<PatchPoint> points;
  points.reserve(axes.size());
  for (std::size_t i = 0; i < axes.size(); ++i) {
    const std::uint32_t vertex = flat.vertices[i];
    const glm::dvec3 normal(mesh.normals[vertex]);
    const glm::dvec3 axis = axes[i] - glm::dot(axes[i], normal) * normal;
    const double length = glm::length(axis);
    const glm::vec3 unit = length > 1e-3 * areas[i] ? glm::vec3(axis / length) : mesh.tangents[vertex];
    points.push_back({vertex, patch, glm::vec2(flat.uv[i]), unit, 0});
  }
  return points;
}

}  // namespace pelage
