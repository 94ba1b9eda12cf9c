#include "renderer/passes/fins/strips.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>
#include <utility>

#include "protocol/base/random.h"

namespace pelage {

namespace {

constexpr std::uint64_t hair_seed = 0x6861697273;

float area_of(const StripMesh& mesh, glm::uvec3 t) {
  const glm::vec3 a = mesh.positions[t.x];
  return 0.5f * glm::length(glm::cross(mesh.positions[t.y] - a, mesh.positions[t.z] - a));
}

std::array<std::uint32_t, 3> welded_corners(const StripMesh& mesh, glm::uvec3 t) {
  return {mesh.welded[t.x], mesh.welded[t.y], mesh.welded[t.z]};
}

/// An edge as one of its triangles has it.
struct HalfEdge {
  std::uint32_t low, high;  // of the model
  glm::uvec2 ends;          // render vertices
  float area;               // of the triangle
};

/// Cosine of the angle between the fur and the way to the eye, and the distance.
struct Facing {
  float cosine, distance;
};
Facing facing(glm::vec3 place, glm::vec3 normal, glm::vec3 eye) {
  const glm::vec3 to_eye = eye - place;
  const float distance = glm::length(to_eye);
  return {glm::dot(to_eye, normal) / std::max(distance * glm::length(normal), 1e-20f), distance};
}

template <class Strip, class FacingOf>
ShownStrips<Strip> choose(std::span<const Strip> all, float limit, const FacingOf& facing_of) {
  std::vector<std::pair<Facing, Strip>> chosen;
  for (const Strip& strip : all) {
    const Facing facing = facing_of(strip);
    if (std::abs(facing.cosine) < limit) chosen.emplace_back(facing, strip);
  }
  const auto behind = [](const auto& a, const auto& b) {
    const bool a_averted = a.first.cosine < 0, b_averted = b.first.cosine < 0;
    return a_averted != b_averted ? a_averted : a.first.distance > b.first.distance;
  };
  std::stable_sort(chosen.begin(), chosen.end(), behind);
  ShownStrips<Strip> shown;
  for (const auto& [facing, strip] : chosen) {
    shown.averted += facing.cosine < 0;
    shown.strips.push_back(strip);
  }
  return shown;
}

}  // namespace

std::vector<glm::uvec3> surface_triangles(const StripMesh& mesh) {
  std::vector<std::size_t> order(mesh.triangles.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  const auto key = [&](std::size_t i) { return welded_corners(mesh, mesh.triangles[i]); };
  std::stable_sort(order.begin(), order.end(), [&](auto a, auto b) { return key(a) < key(b); });
  order.erase(std::unique(order.begin(), order.end(), [&](auto a, auto b) { return key(a) == key(b); }), order.end());
  std::vector<glm::uvec3> triangles;
  for (const std::size_t i : order) triangles.push_back(mesh.triangles[i]);
  return triangles;
}

std::vector<FinEdge> list_edges(const StripMesh& mesh) {
  std::vector<HalfEdge> halves;
  for (const glm::uvec3& t : surface_triangles(mesh)) {
    for (int k = 0; k < 3; ++k) {
      glm::uvec2 ends(t[k], t[(k + 1) % 3]);
      if (mesh.welded[ends.x] > mesh.welded[ends.y]) std::swap(ends.x, ends.y);
      halves.push_back({mesh.welded[ends.x], mesh.welded[ends.y], ends, area_of(mesh, t)});
    }
  }
  const auto key = [](const HalfEdge& half) { return std::pair(half.low, half.high); };
  std::stable_sort(halves.begin(), halves.end(), [&](const auto& a, const auto& b) { return key(a) < key(b); });
  std::vector<FinEdge> edges;
  for (std::size_t i = 0; i < halves.size();) {
    const HalfEdge& first = halves[i];
    float area = 0;
    for (; i < halves.size() && key(halves[i]) == key(first); ++i) area += halves[i].area;
    const float length = glm::distance(mesh.positions[first.ends.x], mesh.positions[first.ends.y]);
    // Half of both triangles' heights. Edges run three ways, and from any side about two of them show: half of that.
    if (length > 0) edges.push_back({first.ends, 0.5f * area / length});
  }
  return edges;
}

std::vector<HairRoot> scatter_hairs(const StripMesh& mesh, int count) {
  const std::vector<glm::uvec3> triangles = surface_triangles(mesh);
  std::vector<double> sums;
  double area = 0;
  for (const glm::uvec3& t : triangles) sums.push_back(area += area_of(mesh, t));
  std::vector<HairRoot> roots;
  if (!(area > 0)) return roots;
  Random random(hair_seed);
  for (int i = 0; i < count; ++i) {
    const double at = (i + random.uniform()) / count * area;  // one in each equal part of the area
    const auto found = std::min<std::size_t>(
        static_cast<std::size_t>(std::upper_bound(sums.begin(), sums.end(), at) - sums.begin()), sums.size() - 1);
    const double root = std::sqrt(random.uniform()), share = random.uniform();  // uniform on a triangle
    const glm::vec3 weights(1 - root, root * (1 - share), root * share);
    roots.push_back({triangles[found], static_cast<std::uint32_t>(random.uniform() * 4294967296.0), weights});
  }
  return roots;
}

ShownStrips<FinEdge> shown_fins(const StripMesh& mesh, std::span<const FinEdge> edges, glm::vec3 eye) {
  return choose(edges, fin_limit, [&](const FinEdge& edge) {
    const Facing a = facing(mesh.positions[edge.ends.x], mesh.normals[edge.ends.x], eye);
    const Facing b = facing(mesh.positions[edge.ends.y], mesh.normals[edge.ends.y], eye);
    return std::abs(a.cosine) < std::abs(b.cosine) ? a : b;  // one end in the band is enough
  });
}

ShownStrips<HairRoot> shown_hairs(const StripMesh& mesh, std::span<const HairRoot> roots, glm::vec3 eye) {
  return choose(roots, hair_limit, [&](const HairRoot& root) {
    glm::vec3 place(0), normal(0);
    for (int k = 0; k < 3; ++k) {
      place += root.weights[k] * mesh.positions[root.corners[k]];
      normal += root.weights[k] * mesh.normals[root.corners[k]];
    }
    return facing(place, normal, eye);
  });
}

}  // namespace pelage
