#include "server/patches/subdivide.h"

#include <algorithm>
#include <array>
#include <string>
#include <tuple>

#include "base/limits.h"
#include "base/parallel.h"
#include "server/surface/adjacency.h"
#include "server/surface/prepare.h"

namespace pelage {

namespace {

/// A point of the subdivided map: one of the old map, or the middle of two of them.
struct Middle {
  std::uint32_t vertex = 0;         // of the subdivided mesh
  std::uint32_t low = 0, high = 0;  // points of the old map; equal for an old point

  auto order() const { return std::tie(vertex, low, high); }
  bool operator<(const Middle& other) const { return order() < other.order(); }
  bool operator==(const Middle& other) const { return order() == other.order(); }
};

/// A patch triangle of the subdivided map before its points are numbered.
struct NewPatchTriangle {
  std::uint32_t triangle = 0, patch = 0;
  std::array<Middle, 3> corners;
};

float weight_of(const PatchMap& map, const Middle& middle) {
  return static_cast<float>((double{map.points[middle.low].weight} + double{map.points[middle.high].weight}) / 2);
}

NewPatchTriangle split_patch_triangle(const PatchTriangle& patch_triangle, const ChildTriangle& child,
                                      std::uint32_t triangle, const Mesh& subdivided) {
  NewPatchTriangle result{triangle, patch_triangle.patch, {}};
  for (std::size_t k = 0; k < 3; ++k) {
    const int corner = child.corners[k];
    const std::uint32_t a = patch_triangle.points[corner % 3];
    const std::uint32_t b = corner < 3 ? a : patch_triangle.points[(corner + 1) % 3];
    result.corners[k] = {subdivided.triangles[triangle][static_cast<int>(k)], std::min(a, b), std::max(a, b)};
  }
  return result;
}

/// Returns the patch triangles of all children, by triangle, then patch.
std::vector<NewPatchTriangle> split_patch_triangles(const PatchMap& map, const std::vector<ChildTriangle>& children,
                                                    const Mesh& subdivided) {
  std::vector<NewPatchTriangle> patch_triangles;
  std::size_t begin = 0, end = 0;  // patch triangles of the parent
  for (std::uint32_t t = 0; t < children.size(); ++t) {
    while (map.patch_triangles[begin].triangle < children[t].parent) ++begin;
    for (end = begin; end < map.patch_triangles.size() && map.patch_triangles[end].triangle == children[t].parent;
         ++end) {
      const NewPatchTriangle patch_triangle =
          split_patch_triangle(map.patch_triangles[end], children[t], t, subdivided);
      const bool counts = std::any_of(patch_triangle.corners.begin(), patch_triangle.corners.end(),
                                      [&](const Middle& corner) { return weight_of(map, corner) > 0; });
      if (counts) patch_triangles.push_back(patch_triangle);
    }
  }
  return patch_triangles;
}

/// Returns `axis` projected orthogonal to the unit normal, unit; the tailward direction if the projection vanishes.
glm::vec3 across(glm::dvec3 axis, glm::dvec3 normal) {
  constexpr double vanishing = 1e-4;
  axis -= glm::dot(axis, normal) * normal;
  const double length = glm::length(axis);
  return glm::vec3(length > vanishing ? axis / length : tailward(normal));
}

PatchPoint make_point(const PatchMap& map, const Middle& middle, const Mesh& subdivided) {
  const PatchPoint &a = map.points[middle.low], &b = map.points[middle.high];
  if (middle.low == middle.high) return a;
  const glm::dvec3 axis = glm::dvec3(a.axis) + glm::dvec3(b.axis);
  return {middle.vertex, a.patch, glm::vec2((glm::dvec2(a.uv) + glm::dvec2(b.uv)) / 2.0),
          across(axis, glm::dvec3(subdivided.normals[middle.vertex])), weight_of(map, middle)};
}

}  // namespace

PatchMap subdivide_patches(const PatchMap& map, const std::vector<ChildTriangle>& children, const Mesh& subdivided) {
  const std::vector<NewPatchTriangle> patch_triangles = split_patch_triangles(map, children, subdivided);
  std::vector<std::vector<Middle>> of_patch(map.patches);
  for (const NewPatchTriangle& patch_triangle : patch_triangles)
    of_patch[patch_triangle.patch].insert(of_patch[patch_triangle.patch].end(), patch_triangle.corners.begin(),
                                          patch_triangle.corners.end());
  for_each_in_parallel(map.patches, [&](std::uint32_t p) {
    std::sort(of_patch[p].begin(), of_patch[p].end());
    of_patch[p].erase(std::unique(of_patch[p].begin(), of_patch[p].end()), of_patch[p].end());
  });
  PatchMap result{{}, {}, map.patches};
  std::vector<std::uint32_t> first;
  for (const std::vector<Middle>& middles : of_patch) {
    first.push_back(static_cast<std::uint32_t>(result.points.size()));
    for (const Middle& middle : middles) result.points.push_back(make_point(map, middle, subdivided));
  }
  for (const NewPatchTriangle& patch_triangle : patch_triangles) {
    PatchTriangle& numbered =
        result.patch_triangles.emplace_back(PatchTriangle{patch_triangle.triangle, patch_triangle.patch, {}});
    const std::vector<Middle>& middles = of_patch[patch_triangle.patch];
    for (std::size_t k = 0; k < 3; ++k) {
      const auto found = std::lower_bound(middles.begin(), middles.end(), patch_triangle.corners[k]);
      numbered.points[static_cast<int>(k)] =
          first[patch_triangle.patch] + static_cast<std::uint32_t>(found - middles.begin());
    }
  }
  return result;
}

namespace {

constexpr std::uint32_t unsplit = 0xffffffff;  // in place of a middle: the side is not split

/// The middles of all sides that are halved.
struct Middles {
  std::vector<std::array<std::uint32_t, 3>> of;  // by triangle and side: the new vertex, or `unsplit`
  std::vector<glm::uvec2> parents;
};

glm::vec3 middle_of(const Mesh& mesh, std::uint32_t a, std::uint32_t b) {
  return glm::vec3((glm::dvec3(mesh.positions[a]) + glm::dvec3(mesh.positions[b])) / 2.0);
}

/// Halves each edge of a chosen triangle, once for all triangles that share it.
Middles halve_edges(const Mesh& mesh, const std::vector<bool>& chosen) {
  Middles middles;
  middles.of.assign(mesh.triangles.size(), {unsplit, unsplit, unsplit});
  const auto first = static_cast<std::uint32_t>(mesh.positions.size());
  for_each_edge(sorted_sides(mesh.triangles), [&](std::span<const Side> edge) {
    const std::uint32_t low = edge[0].low, high = edge[0].high;
    if (std::none_of(edge.begin(), edge.end(), [&](const Side& side) { return chosen[side.triangle]; })) return;
    const glm::vec3 middle = middle_of(mesh, low, high);
    if (middle == mesh.positions[low] || middle == mesh.positions[high]) return;
    for (const Side& side : edge)
      middles.of[side.triangle][side.side] = first + static_cast<std::uint32_t>(middles.parents.size());
    middles.parents.emplace_back(low, high);
  });
  return middles;
}

/// Returns the distance from a corner of a triangle to the middle of one of its sides, which must be halved.
double distance_to_middle(const Mesh& mesh, const Middles& middles, std::uint32_t triangle, int corner, int side) {
  const std::uint32_t vertex = middles.of[triangle][static_cast<std::size_t>(side)];
  const glm::uvec2 ends = middles.parents[vertex - mesh.positions.size()];
  const glm::vec3 from = mesh.positions[mesh.triangles[triangle][corner]];
  return glm::distance(glm::dvec3(from), glm::dvec3(middle_of(mesh, ends.x, ends.y)));
}

/// Adds three triangles for one with two halved sides. The quadrilateral at the unsplit side is cut along its shorter
/// diagonal.
void add_three(const Mesh& mesh, const Middles& middles, std::uint32_t triangle, int unsplit_side,
               std::vector<ChildTriangle>& children) {
  const int a = unsplit_side, b = (a + 1) % 3, c = (a + 2) % 3;
  const auto corner = [](int k) { return static_cast<std::uint8_t>(k); };
  const std::uint8_t after = corner(3 + b), before = corner(3 + c);  // middles of the sides from b to c, from c to a
  const auto length = [&](int from, int side) { return distance_to_middle(mesh, middles, triangle, from, side); };
  children.push_back({triangle, {after, corner(c), before}});
  if (length(a, b) <= length(b, c)) {
    children.push_back({triangle, {corner(a), corner(b), after}});
    children.push_back({triangle, {corner(a), after, before}});
  } else {
    children.push_back({triangle, {corner(a), corner(b), before}});
    children.push_back({triangle, {corner(b), after, before}});
  }
}

void add_children(const Mesh& mesh, const Middles& middles, std::uint32_t triangle,
                  std::vector<ChildTriangle>& children) {
  const std::array<std::uint32_t, 3>& sides = middles.of[triangle];
  const auto halved = 3 - std::count(sides.begin(), sides.end(), unsplit);
  if (halved == 0) {
    children.push_back({triangle, {0, 1, 2}});
  } else if (halved == 1) {
    const auto a = static_cast<std::uint8_t>(
        std::find_if(sides.begin(), sides.end(), [](std::uint32_t m) { return m != unsplit; }) - sides.begin());
    const auto b = static_cast<std::uint8_t>((a + 1) % 3), c = static_cast<std::uint8_t>((a + 2) % 3);
    const auto middle = static_cast<std::uint8_t>(3 + a);
    children.push_back({triangle, {a, middle, c}});
    children.push_back({triangle, {middle, b, c}});
  } else if (halved == 2) {
    const auto side = std::find(sides.begin(), sides.end(), unsplit) - sides.begin();
    add_three(mesh, middles, triangle, static_cast<int>(side), children);
  } else {
    for (const std::array<std::uint8_t, 3>& corners :
         {std::array<std::uint8_t, 3>{0, 3, 5}, {3, 1, 4}, {5, 4, 2}, {3, 4, 5}})
      children.push_back({triangle, corners});
  }
}

void add_vertex(const Mesh& mesh, glm::uvec2 parents, Mesh& subdivided) {
  constexpr double vanishing = 1e-4;
  const auto [a, b] = std::pair(parents.x, parents.y);
  const glm::dvec3 sum = glm::dvec3(mesh.normals[a]) + glm::dvec3(mesh.normals[b]);
  const glm::dvec3 normal =
      glm::length(sum) > vanishing ? glm::normalize(sum) : glm::normalize(glm::dvec3(mesh.normals[a]));
  glm::dvec3 tangent = glm::dvec3(mesh.tangents[a]) + glm::dvec3(mesh.tangents[b]);
  tangent -= glm::dot(tangent, normal) * normal;
  const double length = glm::length(tangent);
  subdivided.positions.push_back(middle_of(mesh, a, b));
  subdivided.normals.emplace_back(normal);
  subdivided.tangents.emplace_back(length > vanishing ? tangent / length : tailward(normal));
  subdivided.length_scale.push_back(
      static_cast<float>((double{mesh.length_scale[a]} + double{mesh.length_scale[b]}) / 2));
}

LookCorner mean(const LookCorner& a, const LookCorner& b) {
  return {(a.uv + b.uv) * 0.5f, (a.colour + b.colour) * 0.5f, a.image};
}
glm::vec2 mean(glm::vec2 a, glm::vec2 b) { return (a + b) * 0.5f; }

/// Returns the mean of unit normals, unit.
glm::vec3 mean(glm::vec3 a, glm::vec3 b) {
  constexpr double vanishing = 1e-4;
  const glm::dvec3 sum = glm::dvec3(a) + glm::dvec3(b);
  return glm::length(sum) > vanishing ? glm::vec3(glm::normalize(sum)) : a;
}

/// Returns the data of each corner of the children: that of the parent's corner, or the mean of a side's ends.
template <class Corner>
std::vector<std::array<Corner, 3>> corners_of(const std::vector<std::array<Corner, 3>>& before,
                                              const std::vector<ChildTriangle>& children) {
  std::vector<std::array<Corner, 3>> result;
  if (before.empty()) return result;
  result.reserve(children.size());
  for (const ChildTriangle& child : children) {
    const std::array<Corner, 3>& own = before[child.parent];
    const auto at = [&](std::size_t c) { return c < 3 ? own[c] : mean(own[c - 3], own[(c - 2) % 3]); };
    result.push_back({at(child.corners[0]), at(child.corners[1]), at(child.corners[2])});
  }
  return result;
}

Mesh subdivide_mesh(const Mesh& mesh, const Middles& middles, const std::vector<ChildTriangle>& children) {
  Mesh subdivided = mesh;
  for (const glm::uvec2 parents : middles.parents) add_vertex(mesh, parents, subdivided);
  subdivided.triangles.clear(), subdivided.materials.clear();
  for (MaterialReport& material : subdivided.report.materials) material.triangles = 0;
  subdivided.triangles.reserve(children.size());
  for (const ChildTriangle& child : children) {
    const auto at = [&](std::size_t c) {
      return c < 3 ? mesh.triangles[child.parent][static_cast<int>(c)] : middles.of[child.parent][c - 3];
    };
    subdivided.triangles.emplace_back(at(child.corners[0]), at(child.corners[1]), at(child.corners[2]));
    if (mesh.materials.empty()) continue;
    const std::uint16_t material = subdivided.materials.emplace_back(mesh.materials[child.parent]);
    if (material != no_material) ++subdivided.report.materials[material].triangles;
  }
  subdivided.shading_normals = corners_of(mesh.shading_normals, children);
  subdivided.corners = corners_of(mesh.corners, children);
  subdivided.texture_uv = corners_of(mesh.texture_uv, children);
  subdivided.report.vertices = subdivided.positions.size();
  subdivided.report.triangles = subdivided.triangles.size();
  return subdivided;
}

Status too_many(std::size_t triangles) {
  return failure(Code::invalid, "The finer model would have " + std::to_string(triangles) + " triangles.", "",
                 "at most " + std::to_string(limits::model_triangles));
}

/// Returns for each triangle whether it is chosen.
Result<std::vector<bool>> flags_of(const ChosenTriangles& chosen, std::size_t triangles) {
  std::vector<bool> flags(triangles, false);
  for (const TriangleRun& run : chosen) {
    if (run.begin >= run.end || run.end > triangles) return failure(Code::invalid, "The model has no such triangle.");
    std::fill(flags.begin() + run.begin, flags.begin() + run.end, true);
  }
  return flags;
}

}  // namespace

Result<SubdividedSurface> subdivide(const Mesh& mesh, const PatchMap& patches, const ChosenTriangles& chosen) {
  const Result<std::vector<bool>> flags = flags_of(chosen, mesh.triangles.size());
  if (!flags) return flags.status();
  Middles middles = halve_edges(mesh, *flags);
  std::vector<ChildTriangle> children;
  children.reserve(mesh.triangles.size() + 2 * middles.parents.size());
  for (std::uint32_t t = 0; t < mesh.triangles.size(); ++t) add_children(mesh, middles, t, children);
  if (children.size() > limits::model_triangles) return too_many(children.size());
  Mesh subdivided = subdivide_mesh(mesh, middles, children);
  PatchMap map = subdivide_patches(patches, children, subdivided);
  return SubdividedSurface{std::move(subdivided), std::move(map), std::move(middles.parents)};
}

}  // namespace pelage
