#include <algorithm>
#include <cmath>
#include <map>
#include <numeric>
#include <optional>
#include <tuple>

#include "server/patches/patches.h"
#include "server/surface/adjacency.h"

namespace pelage {

namespace {

glm::vec2 uv_at(const Mesh& mesh, std::uint32_t triangle, std::uint32_t corner) {
  return mesh.texture_uv[triangle][corner];
}

/// Returns the texture coordinates of a side at its low and its high vertex.
std::pair<glm::vec2, glm::vec2> uv_along(const Mesh& mesh, const Side& side) {
  const glm::vec2 first = uv_at(mesh, side.triangle, side.side);
  const glm::vec2 second = uv_at(mesh, side.triangle, (side.side + 1) % 3);
  return side.rising ? std::pair(first, second) : std::pair(second, first);
}

std::uint32_t root_of(std::vector<std::uint32_t>& parents, std::uint32_t t) {
  while (parents[t] != t) t = parents[t] = parents[parents[t]];
  return t;
}

/// Returns the triangles of each island; an island is connected by sides with equal texture coordinates.
std::vector<std::vector<std::uint32_t>> islands_of(const Mesh& mesh) {
  std::vector<std::uint32_t> parents(mesh.triangles.size());
  std::iota(parents.begin(), parents.end(), 0u);
  for_each_edge(sorted_sides(mesh.triangles), [&](std::span<const Side> edge) {
    for (std::size_t i = 1; i < edge.size(); ++i) {
      if (uv_along(mesh, edge[0]) != uv_along(mesh, edge[i])) continue;
      const std::uint32_t a = root_of(parents, edge[0].triangle), b = root_of(parents, edge[i].triangle);
      parents[std::max(a, b)] = std::min(a, b);
    }
  });
  std::vector<std::vector<std::uint32_t>> islands;
  std::vector<std::size_t> island(parents.size());
  for (std::uint32_t t = 0; t < parents.size(); ++t) {
    const std::uint32_t root = root_of(parents, t);
    if (root == t) island[t] = islands.size(), islands.emplace_back();
    islands[island[root]].push_back(t);
  }
  return islands;
}

double twice_area(const Mesh& mesh, std::uint32_t t) {
  const glm::uvec3& v = mesh.triangles[t];
  const glm::dvec3 a(mesh.positions[v.x]), b(mesh.positions[v.y]), c(mesh.positions[v.z]);
  return glm::length(glm::cross(b - a, c - a));
}

double twice_uv_area(const Mesh& mesh, std::uint32_t t) {
  const glm::dvec2 a(uv_at(mesh, t, 0)), d1 = glm::dvec2(uv_at(mesh, t, 1)) - a, d2 = glm::dvec2(uv_at(mesh, t, 2)) - a;
  return d1.x * d2.y - d1.y * d2.x;
}

/// Returns the island as a patch in sizes. A vertex with several texture coordinates occurs several times.
FlatPatch flat_island(const Mesh& mesh, const std::vector<std::uint32_t>& triangles, double scale, bool mirrored) {
  using Key = std::tuple<std::uint32_t, float, float>;
  std::map<Key, std::uint32_t> indices;
  const auto key_of = [&](std::uint32_t t, std::uint32_t k) {
    const glm::vec2 uv = uv_at(mesh, t, k);
    return Key(mesh.triangles[t][static_cast<int>(k)], uv.x, uv.y);
  };
  for (const std::uint32_t t : triangles) {
    for (std::uint32_t k = 0; k < 3; ++k) indices.emplace(key_of(t, k), 0u);
  }
  FlatPatch flat;
  for (auto& [key, index] : indices) {
    index = static_cast<std::uint32_t>(flat.vertices.size());
    flat.vertices.push_back(std::get<0>(key));
    flat.uv.push_back(scale * glm::dvec2(std::get<1>(key), (mirrored ? -1.0 : 1.0) * double{std::get<2>(key)}));
  }
  for (const std::uint32_t t : triangles) {
    flat.triangles.emplace_back(indices[key_of(t, 0)], indices[key_of(t, 1)], indices[key_of(t, 2)]);
  }
  return flat;
}

/// Returns the sizes per unit of the island's texture coordinates, negative for a mirrored island; `fallback` if they
/// span no area.
double scale_of(const Mesh& mesh, const std::vector<std::uint32_t>& triangles, double fallback) {
  double area = 0, uv_area = 0, signed_area = 0;
  for (const std::uint32_t t : triangles) {
    area += twice_area(mesh, t);
    uv_area += std::abs(twice_uv_area(mesh, t));
    signed_area += twice_uv_area(mesh, t);
  }
  const double scale = std::sqrt(area / uv_area);
  const bool usable = uv_area > 0 && std::isfinite(scale) && scale > 0;
  return (usable ? scale : fallback) * (signed_area < 0 ? -1 : 1);
}

/// Returns the sizes per unit of texture coordinates over the whole model; none if they span no area.
std::optional<double> mean_scale(const Mesh& mesh) {
  double area = 0, uv_area = 0;
  for (std::uint32_t t = 0; !mesh.texture_uv.empty() && t < mesh.triangles.size(); ++t) {
    area += twice_area(mesh, t);
    uv_area += std::abs(twice_uv_area(mesh, t));
  }
  const double scale = std::sqrt(area / uv_area);
  return uv_area > 0 && std::isfinite(scale) && scale > 0 ? std::optional(scale) : std::nullopt;
}

}  // namespace

bool has_own_uvs(const Mesh& mesh) { return mean_scale(mesh).has_value(); }

Result<PatchMap> own_uv_patches(const Mesh& mesh) {
  const std::optional<double> fallback = mean_scale(mesh);
  if (!fallback) return failure(Code::invalid, "the model has no texture coordinates of its own");
  PatchMap map;
  for (const std::vector<std::uint32_t>& triangles : islands_of(mesh)) {
    const double scale = scale_of(mesh, triangles, *fallback);
    const FlatPatch flat = flat_island(mesh, triangles, std::abs(scale), scale < 0);
    const auto first = static_cast<std::uint32_t>(map.points.size());
    for (PatchPoint point : make_points(mesh, flat, map.patches)) {
      point.weight = 1;
      map.points.push_back(point);
    }
    for (std::size_t i = 0; i < triangles.size(); ++i) {
      map.patch_triangles.push_back({triangles[i], map.patches, flat.triangles[i] + first});
    }
    ++map.patches;
  }
  std::sort(map.patch_triangles.begin(), map.patch_triangles.end(),
            [](const PatchTriangle& a, const PatchTriangle& b) { return a.triangle < b.triangle; });
  return map;
}

}  // namespace pelage
