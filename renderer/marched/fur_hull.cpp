#include "renderer/marched/fur_hull.h"

#include <algorithm>

#include "protocol/base/lean_curve.h"

namespace pelage {

std::vector<glm::vec3> fur_hull(const MarchMesh& mesh, const Coat& coat) {
  std::vector<glm::vec3> places(mesh.positions.size());
  for (std::size_t i = 0; i < places.size(); ++i) {
    const Lean<float> lean = lean_of(glm::vec2(mesh.groom[i]), mesh.normals[i], mesh.tangents[i]);
    const LeanPoint point = lean_point(coat.lean_curve, double{lean.inclination}, coat.root_share, double{hull_height});
    const glm::vec3 way =
        static_cast<float>(point.across) * lean.along + static_cast<float>(point.up) * mesh.normals[i];
    places[i] = mesh.positions[i] + mesh.groom[i].z * way;
  }
  return places;
}

float radius_of_fur(const MarchMesh& mesh) {
  constexpr float half_diagonal = 0.5f;  // of every model's box, sizes
  float longest = 0;
  for (const glm::vec3& groom : mesh.groom) longest = std::max(longest, groom.z);
  return half_diagonal + longest;
}

}  // namespace pelage
