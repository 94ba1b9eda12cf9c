#include "renderer/marched/field_overlay.h"

#include <algorithm>
#include <cassert>
#include <vector>

#include "renderer/marched/visible_triangles.h"
#include "renderer/overlay/field_picture.h"
#include "renderer/upload/blocks.h"

namespace pelage {

namespace {

std::vector<glm::vec3> values_of(const FurFrame& frame, const MarchMesh& mesh) {
  float longest = 0;
  for (const glm::vec3& groom : mesh.groom) longest = std::max(longest, groom.z);
  const FieldValues value(frame, longest);
  std::vector<glm::vec3> values(mesh.positions.size());
  for (std::size_t i = 0; i < values.size(); ++i) {
    FieldVertex vertex{mesh.positions[i], mesh.normals[i], mesh.tangents[i], mesh.groom[i], mesh.groom[i].z};
    if (!mesh.paint.empty()) vertex.density = mesh.paint[i][0], vertex.wetness = mesh.paint[i][2];
    if (!mesh.mask.empty()) vertex.mask = mesh.mask[i];
    vertex.model_vertex = mesh.welded[i];
    values[i] = value.of(vertex);
  }
  return values;
}

}  // namespace

FloatImage field_overlay(const FurFrame& frame, const MarchMesh& mesh, int threads) {
  assert(is_field(frame.overlay));
  const glm::vec3 forward = frame.camera.forward;
  const PlainView view{
      world_to_clip(frame), {forward, -glm::dot(forward, frame.camera.position)}, frame.width, frame.height};
  const std::vector<VisibleTriangle> visible = visible_triangles(mesh.positions, mesh.triangles, view, threads);
  const std::vector<glm::vec3> values = values_of(frame, mesh);
  std::vector<glm::vec3> seen(visible.size());
  for (std::size_t i = 0; i < seen.size(); ++i) {
    const VisibleTriangle& at = visible[i];
    if (!at.there()) continue;
    const glm::uvec3& t = mesh.triangles[at.triangle];
    seen[i] = at_visible(at, values[t.x], values[t.y], values[t.z]);
    seen[i].z = seen[i].z > 0 ? 1 : 0;
  }
  return field_picture(frame, seen, threads);
}

}  // namespace pelage
