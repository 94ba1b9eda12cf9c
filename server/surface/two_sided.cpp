#include "server/surface/two_sided.h"

#include <algorithm>

namespace pelage {

std::size_t add_backs(Soup& soup, const Orientation& orientation, const std::vector<std::uint32_t>& numbers) {
  const std::size_t fronts = soup.positions.size(), triangles = soup.triangles.size();
  std::vector<std::uint32_t> back(fronts, no_position);
  const auto back_of = [&](std::uint32_t v) {
    if (back[v] != no_position) return back[v];
    back[v] = static_cast<std::uint32_t>(soup.positions.size());
    soup.positions.push_back(glm::dvec3(soup.positions[v]));
    soup.sources.push_back(std::uint32_t{soup.sources[v]});
    return back[v];
  };
  for (std::size_t t = 0; t < triangles; ++t) {
    if (std::find(numbers.begin(), numbers.end(), orientation.part_of[t] + 1) == numbers.end()) continue;
    const glm::uvec3 vertices = soup.triangles[t], corners = soup.corners[t];
    soup.add({back_of(vertices.x), back_of(vertices.z), back_of(vertices.y)}, {corners.x, corners.z, corners.y},
             soup.faces[t]);
  }
  return fronts;
}

void lift_backs(Mesh& mesh, std::size_t first) {
  for (std::size_t v = first; v < mesh.positions.size(); ++v)
    mesh.positions[v] += static_cast<float>(sheet_thickness) * mesh.normals[v];
}

}  // namespace pelage
