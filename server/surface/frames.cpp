#include "server/surface/frames.h"

#include <cassert>

namespace pelage {

namespace {

/// The normal of the triangle, as long as twice its area.
glm::dvec3 area_vector(const Soup& soup, const glm::uvec3& t) {
  return glm::cross(soup.positions[t.y] - soup.positions[t.x], soup.positions[t.z] - soup.positions[t.x]);
}

std::vector<glm::dvec3> vertex_normals(const Soup& soup) {
  constexpr double cancelled = 1e-9;
  std::vector<glm::dvec3> sums(soup.positions.size(), glm::dvec3(0)), first(sums);
  std::vector<double> areas(soup.positions.size(), 0);
  for (const glm::uvec3& t : soup.triangles) {
    const glm::dvec3 vector = area_vector(soup, t);
    for (int k = 0; k < 3; ++k) {
      const std::uint32_t v = t[k];
      if (areas[v] == 0) first[v] = vector;
      sums[v] += vector;
      areas[v] += glm::length(vector);
    }
  }
  for (std::size_t v = 0; v < sums.size(); ++v) {
    const glm::dvec3 sum = glm::length(sums[v]) > cancelled * areas[v] ? sums[v] : first[v];
    const double length = glm::length(sum);
    sums[v] = length > 0 ? sum / length : glm::dvec3(0, 1, 0);
  }
  return sums;
}

}  // namespace

glm::dvec3 tailward(glm::dvec3 normal) {
  constexpr double vanishing = 1e-4;
  for (const glm::dvec3 wish : {glm::dvec3(0, 0, -1), glm::dvec3(0, -1, 0)}) {
    const glm::dvec3 tangent = wish - glm::dot(wish, normal) * normal;
    const double length = glm::length(tangent);
    if (length > vanishing) return tangent / length;
  }
  assert(false && "a unit vector is along -Z or along -Y, not both");
  return {1, 0, 0};
}

Frames make_frames(const Soup& soup) {
  Frames frames;
  for (const glm::dvec3& normal : vertex_normals(soup)) {
    frames.normals.emplace_back(normal);
    frames.tangents.emplace_back(tailward(normal));
  }
  return frames;
}

}  // namespace pelage
