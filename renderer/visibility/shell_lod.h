// How many shells each pixel of a view gets: non-uniform shells (fur modelling 2; science.md 1).
//
// There are up to three sets of shells: all of the shells, half and a quarter of them. A vertex's level says how often
// their number may be halved. Before anything else the outer hull of the fur is drawn, which leaves in each pixel the
// set that the level there asks for; each set is then drawn in its own pixels alone. So a ray meets one set, whatever
// places of the skin it passes: the opacity stays true and no crack opens. Where one set passes into the next, pixels
// are dithered, and nothing pops when the camera moves.
#pragma once

#include <array>
#include <cstdint>
#include <glm/glm.hpp>
#include <span>
#include <vector>

#include "protocol/commands/frame.h"
#include "renderer/visibility/set_cells.h"

namespace pelage {

inline constexpr int max_shell_lods = 3;
inline constexpr int min_shells = 8;  // of a set: each slice of the coat is then seen in a step of its own

/// Shells of a set when set 0 has `shells`: half as many in each set after it, but no fewer than min_shells.
int shells_of_set(int shells, int set);

/// LODs that differ, in [1, max_shell_lods].
int sets_of(int shells, ShellPolicy policy);

/// Texture steps in a slab of a set: as many over the height of the fur as with all shells, at most 16 a slab.
int steps_of_set(const Knobs& knobs, int set);

/// Cosine between view and normal: fur on triangles turned further away lies behind the skin that is front-facing, but
/// for long fur on thin parts.
inline constexpr float furthest_back_facing = -0.6f;

struct ShellView {
  glm::vec3 viewpoint{0};
  float pixel = 0;  // size of a pixel at distance 1
  int shells = 16;
  ShellPolicy policy = ShellPolicy::adaptive;
  float furthest = furthest_back_facing;  // cosine from which on triangles are drawn; -2 draws all
  glm::mat4 to_clip{1};
  float stretch = 1;    // fur is up to so many times as long as its field says
  CellBox part{};       // of the picture that is drawn
  int depth_parts = 1;  // at most, in which fur is drawn from far to near
};

/// What a vertex brings: `length` of its fur in sizes, `curvature` of the skin in 1 / sizes.
struct ShellVertex {
  glm::vec3 position{0}, normal{0, 0, 1};
  float length = 0, curvature = 0;
};

/// How often the number of shells may be halved at a vertex, in [0, sets_of - 1]: shells follow the tangent of the
/// angle between view and fur and the bending of the skin over the fur's length, as a thick shell goes straight on;
/// they need not lie closer than a pixel. Continuous in all of its arguments but the number of shells.
float shell_lod_level(const ShellView& view, const ShellVertex& vertex);

/// Mean over the edges at each vertex of the change of the normal over the edge's length, 1 / sizes.
std::vector<float> curvatures(std::span<const glm::vec3> positions, std::span<const glm::vec3> normals,
                              std::span<const glm::uvec3> triangles);

/// Change of level over which pixels of two sets are mixed.
inline constexpr float dithered_levels = 0.25f;

/// Triangles as seen from an eye, as indices of vertices; for each set those that may show in its pixels.
struct ShellLists {
  using OfSets = std::array<std::vector<glm::uvec3>, max_shell_lods>;
  OfSets facing, back_facing;  // back-facing only near silhouettes: further away they lie behind the skin
  OfSets marks;                // those of the facing ones that may ask for a set; none when a frame has one set only
};

struct ShellMesh {
  std::span<const glm::uvec3> triangles;
  std::span<const glm::vec3> centroids, normals;  // of triangles; normals of any length
  std::span<const glm::vec3> positions;           // of vertices
  std::span<const float> lengths, levels;
  std::span<const CellBox> cells;  // that the fur of a vertex may reach
};

/// Triangles that do not reach the view's part, at most the picture, are left out.
ShellLists sort_triangles(const ShellMesh& mesh, const ShellView& view);

/// The triangles of both lists. Nothing else may write the depth of dense fur, or thin parts show holes where
/// fur that is not drawn hides what is.
std::vector<glm::uvec3> shown_triangles(const ShellMesh& mesh, const ShellView& view);

/// Those that reach a part of the picture.
std::vector<glm::uvec3> triangles_in(const CellBox& part, const ShellMesh& mesh, std::span<const glm::uvec3> triangles);

/// The cells that the fur of a triangle may reach.
CellBox cells_of(const ShellMesh& mesh, const glm::uvec3& triangle);

}  // namespace pelage
