#include "server/patches/refine_patches.h"

#include <algorithm>
#include <tuple>

#include "server/surface/frames.h"
#include "protocol/base/parallel.h"

namespace pelage {

namespace {

/// A point of the refined map: one of the old map, or the middle of two of them.
struct Middle {
  std::uint32_t vertex = 0;         // of the refined mesh
  std::uint32_t low = 0, high = 0;  // points of the old map; the same for a point that was there

  auto order() const { return std::tie(vertex, low, high); }
  bool operator<(const Middle& other) const { return order() < other.order(); }
  bool operator==(const Middle& other) const { return order() == other.order(); }
};

/// A piece of the refined map before its points have numbers.
struct NewPiece {
  std::uint32_t triangle = 0, patch = 0;
  std::array<Middle, 3> corners;
};

float weight_of(const PatchMap& map, const Middle& middle) {
  return static_cast<float>((double{map.points[middle.low].weight} + double{map.points[middle.high].weight}) / 2);
}

NewPiece split_piece(const Piece& piece, const ChildTriangle& child, std::uint32_t triangle, const Mesh& refined) {
  NewPiece result{triangle, piece.patch, {}};
  for (std::size_t k = 0; k < 3; ++k) {
    const int corner = child.corners[k];
    const std::uint32_t a = piece.points[corner % 3];
    const std::uint32_t b = corner < 3 ? a : piece.points[(corner + 1) % 3];
    result.corners[k] = {refined.triangles[triangle][static_cast<int>(k)], std::min(a, b), std::max(a, b)};
  }
  return result;
}

/// The pieces of all children, by triangle, then patch.
std::vector<NewPiece> split_pieces(const PatchMap& map, const std::vector<ChildTriangle>& children,
                                   const Mesh& refined) {
  std::vector<NewPiece> pieces;
  std::size_t begin = 0, end = 0;  // pieces of the parent
  for (std::uint32_t t = 0; t < children.size(); ++t) {
    while (map.pieces[begin].triangle < children[t].parent) ++begin;
    for (end = begin; end < map.pieces.size() && map.pieces[end].triangle == children[t].parent; ++end) {
      const NewPiece piece = split_piece(map.pieces[end], children[t], t, refined);
      const bool counts = std::any_of(piece.corners.begin(), piece.corners.end(),
                                      [&](const Middle& corner) { return weight_of(map, corner) > 0; });
      if (counts) pieces.push_back(piece);
    }
  }
  return pieces;
}

/// The unit vector along `axis` across the unit normal; any across it where that vanishes.
glm::vec3 across(glm::dvec3 axis, glm::dvec3 normal) {
  constexpr double vanishing = 1e-4;
  axis -= glm::dot(axis, normal) * normal;
  const double length = glm::length(axis);
  return glm::vec3(length > vanishing ? axis / length : tailward(normal));
}

PatchPoint make_point(const PatchMap& map, const Middle& middle, const Mesh& refined) {
  const PatchPoint &a = map.points[middle.low], &b = map.points[middle.high];
  if (middle.low == middle.high) return a;
  const glm::dvec3 axis = glm::dvec3(a.axis) + glm::dvec3(b.axis);
  return {middle.vertex, a.patch, glm::vec2((glm::dvec2(a.uv) + glm::dvec2(b.uv)) / 2.0),
          across(axis, glm::dvec3(refined.normals[middle.vertex])), weight_of(map, middle)};
}

}  // namespace

PatchMap refine_patches(const PatchMap& map, const std::vector<ChildTriangle>& children, const Mesh& refined) {
  const std::vector<NewPiece> pieces = split_pieces(map, children, refined);
  std::vector<std::vector<Middle>> of_patch(map.patches);
  for (const NewPiece& piece : pieces)
    of_patch[piece.patch].insert(of_patch[piece.patch].end(), piece.corners.begin(), piece.corners.end());
  for_each_in_parallel(map.patches, [&](std::uint32_t p) {
    std::sort(of_patch[p].begin(), of_patch[p].end());
    of_patch[p].erase(std::unique(of_patch[p].begin(), of_patch[p].end()), of_patch[p].end());
  });
  PatchMap result{{}, {}, map.patches};
  std::vector<std::uint32_t> first;
  for (const std::vector<Middle>& middles : of_patch) {
    first.push_back(static_cast<std::uint32_t>(result.points.size()));
    for (const Middle& middle : middles) result.points.push_back(make_point(map, middle, refined));
  }
  for (const NewPiece& piece : pieces) {
    Piece& numbered = result.pieces.emplace_back(Piece{piece.triangle, piece.patch, {}});
    const std::vector<Middle>& middles = of_patch[piece.patch];
    for (std::size_t k = 0; k < 3; ++k) {
      const auto found = std::lower_bound(middles.begin(), middles.end(), piece.corners[k]);
      numbered.points[static_cast<int>(k)] = first[piece.patch] + static_cast<std::uint32_t>(found - middles.begin());
    }
  }
  return result;
}

}  // namespace pelage
