#include "server/patches/patches.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <queue>

#include "base/parallel.h"
#include "base/random.h"
#include "server/patches/patch_cells.h"
#include "server/surface/value_noise.h"

namespace pelage {

namespace {

/// The patches while they are made.
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

/// Returns whether so much of the patch is stretched that it would be visible in the fur's density. Splitting a cell
/// with few vertices costs more overlap than it saves stretch, so the limit is higher there.
bool stretches_too_much(const Mesh& mesh, const FlatPatch& flat, std::size_t cell_size) {
  constexpr double allowed_share = 0.04;
  constexpr std::size_t few = 20;
  const double max = cell_size < few ? 1.7 : 1.3;
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
    if (stretch.flipped || stretch.large > max || stretch.small < 1 / max) bad += twice;
  }
  return bad > allowed_share * area;
}

/// Splits the cells of patches that stretch too much. Returns whether there were any.
bool split_stretched(const Mesh& mesh, const VertexGraph& graph, const Layout& layout, Cells& cells) {
  const std::uint32_t before = cells.count;
  const Adjacency members = members_of(cells);
  for (std::uint32_t p = 0; p < before; ++p) {
    if (stretches_too_much(mesh, layout.flat[p], members.of(p).size())) split_cell(graph, cells, p);
  }
  return cells.count > before;
}

/// Returns the points of patch p with their shares, moved to a random position on the tile.
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
      map.patch_triangles.push_back({triangles[i], p, layout.flat[p].triangles[i] + first});
    }
  }
  std::sort(map.patch_triangles.begin(), map.patch_triangles.end(), [](const PatchTriangle& a, const PatchTriangle& b) {
    return std::pair(a.triangle, a.patch) < std::pair(b.triangle, b.patch);
  });
  return map;
}

float weight_sum(const PatchMap& map, const PatchTriangle& patch_triangle) {
  return map.points[patch_triangle.points.x].weight + map.points[patch_triangle.points.y].weight +
         map.points[patch_triangle.points.z].weight;
}

}  // namespace

PatchMap lay_patches(const Mesh& mesh) {
  constexpr int max_rounds = 4;
  const VertexGraph graph = make_vertex_graph(mesh);
  Cells cells = partition(mesh, graph, {});
  Layout layout = lay_out(mesh, graph, cells);
  for (int round = 0; round < max_rounds && split_stretched(mesh, graph, layout, cells); ++round) {
    layout = lay_out(mesh, graph, cells);
  }
  return assemble(mesh, layout);
}

PatchMap with_hard_borders(const PatchMap& map) {
  PatchMap hard{map.points, {}, map.patches};
  for (PatchPoint& point : hard.points) point.weight = 1;
  for (std::size_t i = 0; i < map.patch_triangles.size();) {
    const PatchTriangle* best = &map.patch_triangles[i];
    const std::uint32_t triangle = best->triangle;
    for (; i < map.patch_triangles.size() && map.patch_triangles[i].triangle == triangle; ++i) {
      if (weight_sum(map, map.patch_triangles[i]) > weight_sum(map, *best)) best = &map.patch_triangles[i];
    }
    hard.patch_triangles.push_back(*best);
  }
  return hard;
}

Stretch stretch_of(const Mesh& mesh, const PatchMap& map, const PatchTriangle& patch_triangle) {
  std::array<glm::dvec3, 3> p;
  std::array<glm::dvec2, 3> uv;
  for (std::size_t k = 0; k < 3; ++k) {
    const PatchPoint& point = map.points[patch_triangle.points[static_cast<int>(k)]];
    p[k] = glm::dvec3(mesh.positions[point.vertex]), uv[k] = glm::dvec2(point.uv);
  }
  return stretch_of(p, uv);
}

namespace {

/// Returns the direction in space in which u grows on the triangle, as long as twice its area; 0 where that is
/// undefined.
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

namespace {

/// A vertex within the overlap of another cell than its own.
struct Reach {
  std::uint32_t vertex, patch;
  double distance;  // from the patch's cell, made irregular by noise, sizes
};

/// Finds the vertices around each cell.
class ReachFinder {
 public:
  ReachFinder(const Mesh& mesh, const VertexGraph& graph, const Cells& cells, double width)
      : mesh_(mesh),
        graph_(graph),
        cells_(cells),
        width_(width),
        distance_(mesh.positions.size(), std::numeric_limits<double>::infinity()) {}

  /// Returns the vertices around all cells, by rising vertex, then patch.
  std::vector<Reach> find_all() {
    const Adjacency members = members_of(cells_);
    for (std::uint32_t c = 0; c < cells_.count; ++c) find_around(c, members.of(c));
    std::sort(found_.begin(), found_.end(), [](const Reach& a, const Reach& b) {
      return std::pair(a.vertex, a.patch) < std::pair(b.vertex, b.patch);
    });
    return std::move(found_);
  }

 private:
  using Visit = std::pair<double, std::uint32_t>;

  void find_around(std::uint32_t cell, std::span<const std::uint32_t> members) {
    std::vector<std::uint32_t> touched;
    for (const std::uint32_t v : members) step_out(cell, v, 0, touched);
    while (!front_.empty()) {
      const auto [so_far, v] = front_.top();
      front_.pop();
      if (so_far == distance_[v]) step_out(cell, v, so_far, touched);
    }
    std::sort(touched.begin(), touched.end());
    touched.erase(std::unique(touched.begin(), touched.end()), touched.end());
    for (const std::uint32_t v : touched) {
      const double reach = distance_[v] * (1 + raggedness(v, cell));
      if (reach < width_) found_.push_back({v, cell, reach});
      distance_[v] = std::numeric_limits<double>::infinity();
    }
  }

  void step_out(std::uint32_t cell, std::uint32_t from, double so_far, std::vector<std::uint32_t>& touched) {
    for (const std::uint32_t next : graph_.neighbours.of(from)) {
      if (cells_.cell[next] == cell) continue;
      const glm::dvec3 a(mesh_.positions[from]), b(mesh_.positions[next]);
      const double reached = so_far + glm::distance(a, b);
      if (!(reached < distance_[next]) || reached > width_ / (1 - ragged_share)) continue;
      distance_[next] = reached;
      touched.push_back(next);
      front_.emplace(reached, next);
    }
  }

  static constexpr double ragged_share = 0.6;

  double raggedness(std::uint32_t vertex, std::uint32_t cell) const {
    constexpr double length = 0.012;  // of the noise, sizes; the width of some strands
    return ragged_share * value_noise(glm::dvec3(mesh_.positions[vertex]) / length, cell + 2);
  }

  const Mesh& mesh_;
  const VertexGraph& graph_;
  const Cells& cells_;
  double width_;
  std::vector<double> distance_;
  std::vector<Reach> found_;
  std::priority_queue<Visit, std::vector<Visit>, std::greater<>> front_;
};

/// Returns the weight of a patch at this distance from its cell, before shares are normalised.
double fall_off(double distance, double width) {
  const double x = std::clamp(1 - distance / width, 0.0, 1.0);
  return x * x * (3 - 2 * x);
}

VertexShares normalised(const Cells& cells, const std::vector<Reach>& reaches, double width) {
  constexpr double negligible = 0.03;
  VertexShares result;
  result.begin.push_back(0);
  std::size_t next = 0;
  for (std::uint32_t v = 0; v < cells.cell.size(); ++v) {
    const auto first = static_cast<std::ptrdiff_t>(result.shares.size());
    result.shares.push_back({cells.cell[v], 1});
    float sum = 1;
    for (; next < reaches.size() && reaches[next].vertex == v; ++next) {
      const double weight = width > 0 ? fall_off(reaches[next].distance, width) : 0;
      if (weight < negligible) continue;
      result.shares.push_back({reaches[next].patch, static_cast<float>(weight)});
      sum += static_cast<float>(weight);
    }
    std::sort(result.shares.begin() + first, result.shares.end(),
              [](const PatchShare& a, const PatchShare& b) { return a.patch < b.patch; });
    for (auto share = result.shares.begin() + first; share != result.shares.end(); ++share) share->weight /= sum;
    result.begin.push_back(static_cast<std::uint32_t>(result.shares.size()));
  }
  return result;
}

/// Returns the area of all patch triangles divided by the area of the surface.
double area_factor(const Mesh& mesh, const VertexShares& shares) {
  double patch_triangles = 0, surface = 0;
  std::vector<std::uint32_t> patches;
  for (const glm::uvec3& t : mesh.triangles) {
    const glm::dvec3 a(mesh.positions[t.x]), b(mesh.positions[t.y]), c(mesh.positions[t.z]);
    const double twice = glm::length(glm::cross(b - a, c - a));
    patches_at(shares, t, patches);
    patch_triangles += twice * static_cast<double>(patches.size());
    surface += twice;
  }
  return surface > 0 ? patch_triangles / surface : 1;
}

}  // namespace

VertexShares share_vertices(const Mesh& mesh, const VertexGraph& graph, const Cells& cells, const Overlap& overlap) {
  constexpr int halvings = 6;
  const std::vector<Reach> reaches = ReachFinder(mesh, graph, cells, overlap.width).find_all();
  VertexShares best = normalised(cells, reaches, overlap.width);
  if (area_factor(mesh, best) <= overlap.area_factor) return best;
  best = normalised(cells, reaches, 0);
  double low = 0, high = overlap.width;
  for (int i = 0; i < halvings; ++i) {
    const double middle = (low + high) / 2;
    VertexShares shares = normalised(cells, reaches, middle);
    const bool fits = area_factor(mesh, shares) <= overlap.area_factor;
    (fits ? low : high) = middle;
    if (fits) best = std::move(shares);
  }
  return best;
}

void patches_at(const VertexShares& shares, const glm::uvec3& triangle, std::vector<std::uint32_t>& patches) {
  patches.clear();
  for (int k = 0; k < 3; ++k) {
    for (const PatchShare& share : shares.of(triangle[k])) patches.push_back(share.patch);
  }
  std::sort(patches.begin(), patches.end());
  patches.erase(std::unique(patches.begin(), patches.end()), patches.end());
}

}  // namespace pelage
