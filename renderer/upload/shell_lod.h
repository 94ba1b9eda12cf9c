// How many shells each place of a view gets: non-uniform shells (fur modelling 2; science.md 1).
//
// A vertex's level of detail says how often the number of shells may be halved there. From level 0 to 1 the shells of
// odd numbers get thinner and those below them thicker, until they are gone; from 1 to 2 every second one of the others
// goes the same way. At any level the slabs fill the height of the fur, so the opacity stays true, no crack opens and
// nothing pops. A shell is drawn on the triangles where it has not gone.
#pragma once

#include <array>
#include <cstdint>
#include <glm/glm.hpp>
#include <span>
#include <vector>

#include "protocol/commands/frame.h"

namespace pelage {

inline constexpr int max_shell_lod = 2;
inline constexpr int min_shells = 8;  // that are left: each slice of the coat is then seen in a step of its own

/// How often `shells` may be halved so that min_shells are left, in [0, max_shell_lod].
int max_lod(int shells, ShellPolicy policy);

/// Level from which on a shell is gone; beyond max_shell_lod for those that stay.
int gone_from(int shell);

/// Where the slab of a shell begins at a level in [0, max_shell_lod], in shells from the skin; those of one after the
/// last end at `shells`. renderer/shaders/shell_lod.glsl has the same.
float slab_begin(int shell, int shells, float lod);

/// Cosine between view and normal: fur on triangles turned further away lies behind the skin that is front-facing, but
/// for long fur on thin parts.
inline constexpr float furthest_back_facing = -0.6f;

struct ShellView {
  glm::vec3 viewpoint{0};
  float pixel = 0;  // size of a pixel at distance 1
  int shells = 16;
  ShellPolicy policy = ShellPolicy::adaptive;
  float furthest = furthest_back_facing;  // cosine from which on triangles are drawn; -2 draws all
};

/// What a vertex brings: `length` of its fur in sizes, `curvature` of the skin in 1 / sizes.
struct ShellVertex {
  glm::vec3 position{0}, normal{0, 0, 1};
  float length = 0, curvature = 0;
};

/// Level of detail at a vertex, in [0, max_lod]: shells follow the tangent of the angle between view and fur and the
/// bending of the skin over the fur's length, as a thick shell goes straight on; they need not lie closer than a pixel.
/// Continuous in all of its arguments but the number of shells.
float shell_lod(const ShellView& view, const ShellVertex& vertex);

/// Mean over the edges at each vertex of the change of the normal over the edge's length, 1 / sizes.
std::vector<float> curvatures(std::span<const glm::vec3> positions, std::span<const glm::vec3> normals,
                              std::span<const glm::uvec3> triangles);

/// Triangles as seen from a viewpoint, as indices of vertices: at [lod] those on which shells that are gone from the
/// next level on are still drawn. The last of a view's levels has all, and the shells that stay.
struct ShellLists {
  using OfLods = std::array<std::vector<glm::uvec3>, max_shell_lod + 1>;
  OfLods facing, back_facing;  // back-facing only near silhouettes: further away they lie behind the skin
};

struct ShellMesh {
  std::span<const glm::uvec3> triangles;
  std::span<const glm::vec3> centroids, normals;  // of triangles; normals of any length
  std::span<const glm::vec3> positions;           // of vertices
  std::span<const float> lods;
};

ShellLists sort_triangles(const ShellMesh& mesh, const ShellView& view);

}  // namespace pelage
