#include "server/patches/patches.h"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "protocol/base/random.h"
#include "protocol/base/parallel.h"
#include "server/patches/patch_cells.h"
#include "server/patches/patch_points.h"
#include "server/patches/patch_weights.h"

namespace pelage {

namespace {

/// Patches while they are laid.
struct Layout {
  Cells cells;
  VertexShares shares;
  Adjacency triangles;          // of each patch, rising
  std::vector<FlatPatch> flat;  // of each patch
};

Adjacency triangles_of_patches(const Mesh& mesh, const VertexShares& shares, std::uint32_t count) {
  std::vector<std::uint32_t> patches;
  Adjacency triangles;
  triangles.begin.assign(count + 1, 0);
  for (const glm::uvec3& t : mesh.triangles) {
    patches_at(shares, t, patches);
    for (const std::uint32_t p : patches) ++triangles.begin[p + 1];
  }
  std::partial_sum(triangles.begin.begin(), triangles.begin.end(), triangles.begin.begin());
  triangles.others.resize(triangles.begin.back());
  std::vector<std::uint32_t> next(triangles.begin.begin(), triangles.begin.end() - 1);
  for (std::uint32_t t = 0; t < mesh.triangles.size(); ++t) {
    patches_at(shares, mesh.triangles[t], patches);
    for (const std::uint32_t p : patches) triangles.others[next[p]++] = t;
  }
  return triangles;
}

Layout lay_out(const Mesh& mesh, const VertexGraph& graph, Cells cells) {
  Layout layout;
  layout.cells = std::move(cells);
  layout.shares = share_vertices(mesh, graph, layout.cells, {});
  layout.triangles = triangles_of_patches(mesh, layout.shares, layout.cells.count);
  layout.flat.resize(layout.cells.count);
  const Adjacency members = members_of(layout.cells);
  for_each_in_parallel(layout.cells.count, [&](std::uint32_t p) {
    layout.flat[p] = flatten(mesh, layout.triangles.of(p), middle_vertex(mesh, graph, members.of(p)));
  });
  return layout;
}

/// Whether too much of the patch is stretched so much that the eye would see it in the fur's density. Where a cell has
/// few vertices, splitting it makes more overlap than it saves stretch: then only what is much worse counts.
bool stretches_too_much(const Mesh& mesh, const FlatPatch& flat, std::size_t cell_size) {
  constexpr double allowed_share = 0.04;
  constexpr std::size_t few = 20;
  const double most = cell_size < few ? 1.7 : 1.3;
  double area = 0, bad = 0;
  for (const glm::uvec3& t : flat.triangles) {
    std::array<glm::dvec3, 3> p;
    std::array<glm::dvec2, 3> uv;
    for (std::size_t k = 0; k < 3; ++k) {
      const std::uint32_t v = t[static_cast<int>(k)];
      p[k] = glm::dvec3(mesh.positions[flat.vertices[v]]), uv[k] = flat.uv[v];
    }
    const Stretch stretch = stretch_of(p, uv);
    const double twice = glm::length(glm::cross(p[1] - p[0], p[2] - p[0]));
    area += twice;
    if (stretch.flipped || stretch.large > most || stretch.small < 1 / most) bad += twice;
  }
  return bad > allowed_share * area;
}

/// Splits the cells of patches that stretch too much; gives whether there were any.
bool split_stretched(const Mesh& mesh, const VertexGraph& graph, const Layout& layout, Cells& cells) {
  const std::uint32_t before = cells.count;
  const Adjacency members = members_of(cells);
  for (std::uint32_t p = 0; p < before; ++p) {
    if (stretches_too_much(mesh, layout.flat[p], members.of(p).size())) split_cell(graph, cells, p);
  }
  return cells.count > before;
}

/// Points of patch p with their shares, at a place of the tile of its own.
std::vector<PatchPoint> points_of(const Mesh& mesh, const Layout& layout, std::uint32_t p) {
  std::vector<PatchPoint> points = make_points(mesh, layout.flat[p], p);
  Random random(p, 3);
  const double u = random.uniform(), v = random.uniform();
  for (PatchPoint& point : points) {
    point.uv += glm::vec2(u, v);
    for (const PatchShare& share : layout.shares.of(point.vertex)) {
      if (share.patch == p) point.weight = share.weight;
    }
  }
  return points;
}

PatchMap assemble(const Mesh& mesh, const Layout& layout) {
  PatchMap map;
  map.patches = layout.cells.count;
  for (std::uint32_t p = 0; p < map.patches; ++p) {
    const auto first = static_cast<std::uint32_t>(map.points.size());
    const std::vector<PatchPoint> points = points_of(mesh, layout, p);
    map.points.insert(map.points.end(), points.begin(), points.end());
    const auto triangles = layout.triangles.of(p);
    for (std::size_t i = 0; i < triangles.size(); ++i) {
      map.pieces.push_back({triangles[i], p, layout.flat[p].triangles[i] + first});
    }
  }
  std::sort(map.pieces.begin(), map.pieces.end(), [](const Piece& a, const Piece& b) {
    return std::pair(a.triangle, a.patch) < std::pair(b.triangle, b.patch);
  });
  return map;
}

float weight_sum(const PatchMap& map, const Piece& piece) {
  return map.points[piece.points.x].weight + map.points[piece.points.y].weight + map.points[piece.points.z].weight;
}

}  // namespace

PatchMap lay_patches(const Mesh& mesh) {
  constexpr int most_rounds = 4;
  const VertexGraph graph = make_vertex_graph(mesh);
  Cells cells = partition(mesh, graph, {});
  Layout layout = lay_out(mesh, graph, cells);
  for (int round = 0; round < most_rounds && split_stretched(mesh, graph, layout, cells); ++round) {
    layout = lay_out(mesh, graph, cells);
  }
  return assemble(mesh, layout);
}

PatchMap hard_pieces(const PatchMap& map) {
  PatchMap hard{map.points, {}, map.patches};
  for (PatchPoint& point : hard.points) point.weight = 1;
  for (std::size_t i = 0; i < map.pieces.size();) {
    const Piece* best = &map.pieces[i];
    const std::uint32_t triangle = best->triangle;
    for (; i < map.pieces.size() && map.pieces[i].triangle == triangle; ++i) {
      if (weight_sum(map, map.pieces[i]) > weight_sum(map, *best)) best = &map.pieces[i];
    }
    hard.pieces.push_back(*best);
  }
  return hard;
}

Stretch stretch_of(const Mesh& mesh, const PatchMap& map, const Piece& piece) {
  std::array<glm::dvec3, 3> p;
  std::array<glm::dvec2, 3> uv;
  for (std::size_t k = 0; k < 3; ++k) {
    const PatchPoint& point = map.points[piece.points[static_cast<int>(k)]];
    p[k] = glm::dvec3(mesh.positions[point.vertex]), uv[k] = glm::dvec2(point.uv);
  }
  return stretch_of(p, uv);
}

}  // namespace pelage
