#include "server/export/corner_mesh.h"

#include <algorithm>
#include <map>
#include <tuple>

#include "base/lean_curve.h"
#include "server/fields/coats.h"
#include "server/frames/fur_view.h"

namespace pelage {

namespace {

bool bears_fur(const FieldSet& fields, std::uint32_t vertex) {
  return fields.number(Field::length, vertex) > 0 && fields.number(Field::density, vertex) > 0;
}

}  // namespace

CornerMesh make_corner_mesh(const SceneView& scene, bool whole) {
  const FurTriangles patch_triangles = make_fur_triangles(scene.model.surface.mesh(), scene.model.patches);
  CornerMesh shells;
  std::map<std::tuple<std::uint32_t, float, float>, std::uint32_t> known;
  const auto corner_of = [&](std::uint32_t vertex, const FurCorner& corner) {
    const auto [at, is_new] = known.try_emplace({vertex, corner.tile_uv.x, corner.tile_uv.y},
                                                static_cast<std::uint32_t>(shells.corners.size()));
    if (is_new) shells.corners.push_back({vertex, corner.tile_uv, corner.weight});
    return at->second;
  };
  for (std::size_t t = 0; t < patch_triangles.triangles.size(); ++t) {
    const glm::uvec3 v = patch_triangles.triangles[t];
    const bool furred = bears_fur(scene.fields, v.x) || bears_fur(scene.fields, v.y) || bears_fur(scene.fields, v.z);
    if (!whole && !furred) continue;
    const std::array<FurCorner, 3>& c = patch_triangles.corners[t];
    shells.triangles.emplace_back(corner_of(v.x, c[0]), corner_of(v.y, c[1]), corner_of(v.z, c[2]));
  }
  return shells;
}

std::vector<glm::vec3> positions_at(const SceneView& scene, double s) {
  const Mesh& mesh = scene.model.surface.mesh();
  const Coat& coat = first_unmuted(scene.settings.coats).coat;
  std::vector<glm::vec3> positions(mesh.positions.size());
  for (std::uint32_t v = 0; v < positions.size(); ++v) {
    const glm::dvec3 normal(mesh.normals[v]);
    const Lean lean =
        lean_of(glm::dvec2(scene.fields.value(Field::direction, v)), normal, glm::dvec3(mesh.tangents[v]));
    const LeanPoint at = lean_point(coat.lean_curve, lean.inclination, coat.root_share, s);
    const double length = double{scene.fields.number(Field::length, v)};
    const glm::dvec3 position = glm::dvec3(mesh.positions[v]) + length * (at.across * lean.along + at.up * normal);
    positions[v] = glm::vec3(position * mesh.size);
  }
  return positions;
}

}  // namespace pelage
