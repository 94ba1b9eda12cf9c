// Where the fur that stands out against the background grows: edges that carry fins, and the roots of guard hairs. Both
// are found once for a model and chosen for each view.
#pragma once

#include <cstdint>
#include <glm/glm.hpp>
#include <span>
#include <vector>

namespace pelage {

/// Render vertices of a model, and the model's own vertex of each. A triangle of the surface may come as several
/// pieces.
struct StripMesh {
  std::span<const glm::vec3> positions, normals;
  std::span<const glm::uvec3> triangles;
  std::span<const std::uint32_t> welded;
};

/// An edge of the surface. fin.vert mirrors it.
struct FinEdge {
  glm::uvec2 ends{0};  // render vertices of one piece
  float width = 0;     // sizes: of the strip of surface that it stands for
  float padding = 0;
};
static_assert(sizeof(FinEdge) == 16);

/// The root of a guard hair on a triangle. hair.vert mirrors it.
struct HairRoot {
  glm::uvec3 corners{0};   // render vertices
  std::uint32_t bits = 0;  // random
  glm::vec3 weights{0};    // of the corners, sum 1
  float padding = 0;
};
static_assert(sizeof(HairRoot) == 32);

/// The first piece of each triangle of the surface.
std::vector<glm::uvec3> surface_triangles(const StripMesh& mesh);

/// Every edge of the surface once, in the order of the model's vertices.
std::vector<FinEdge> list_edges(const StripMesh& mesh);

/// Roots spread evenly over the surface's area; deterministic. Empty for a surface without area.
std::vector<HairRoot> scatter_hairs(const StripMesh& mesh, int count);

/// What faces the eye by less than these cosines is drawn, fading in from the limit on. The shaders hold the same.
inline constexpr float fin_limit = 0.15f, hair_limit = 0.6f;

/// What a view shows, far things first. The first `averted` stand on surface turned away from the eye.
template <class Strip>
struct ShownStrips {
  std::vector<Strip> strips;
  std::size_t averted = 0;
};
ShownStrips<FinEdge> shown_fins(const StripMesh& mesh, std::span<const FinEdge> edges, glm::vec3 eye);
ShownStrips<HairRoot> shown_hairs(const StripMesh& mesh, std::span<const HairRoot> roots, glm::vec3 eye);

}  // namespace pelage
