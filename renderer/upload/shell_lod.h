// The number of shells at each position of a view: non-uniform shells (fur modelling 2; science.md 1).
//
// A vertex's shell LOD says how often the number of shells may be halved there. From LOD 0 to 1, shells of odd numbers
// get thinner and those below them thicker, until the odd ones are gone; from 1 to 2 the same happens to every second
// one of the others. At any LOD the slabs fill the height of the fur, so opacity is preserved, no gap opens and nothing
// pops. A shell is drawn on the triangles where it is not gone.
#pragma once

#include <array>
#include <cstdint>
#include <glm/glm.hpp>
#include <span>
#include <vector>

#include "protocol/commands/frame.h"

namespace pelage {

inline constexpr int max_shell_lod = 2;
inline constexpr int min_shells = 8;  // shells left at any LOD, so that each slice of the coat gets a step of its own

/// Returns how often `shells` may be halved so that at least min_shells remain, in [0, max_shell_lod].
int max_lod(int shells, ShellPolicy policy);

/// Returns the LOD from which a shell is gone; above max_shell_lod if it never is.
int gone_from(int shell);

/// Returns the height at which a shell's slab begins at a LOD in [0, max_shell_lod], in shells from the skin; for the
/// shell after the last it is `shells`. Same as in renderer/shaders/shell_lod.glsl.
float slab_begin(int shell, int shells, float lod);

/// Smallest cosine between the normal and the direction to the camera at which fur is drawn: fur on triangles that are
/// further back-facing is hidden by front-facing skin, except long fur on thin parts.
inline constexpr float furthest_back_facing = -0.6f;

struct ShellView {
  glm::vec3 viewpoint{0};
  float pixel = 0;  // size of a pixel at distance 1
  int shells = 16;
  ShellPolicy policy = ShellPolicy::adaptive;
  float furthest = furthest_back_facing;  // triangles with a larger cosine are drawn; -2 draws all
};

/// A vertex: `length` of its fur in sizes, `curvature` of the skin in 1 / sizes.
struct ShellVertex {
  glm::vec3 position{0}, normal{0, 0, 1};
  float length = 0, curvature = 0;
};

/// Returns the shell LOD at a vertex, in [0, max_lod]. The number of shells follows the tangent of the angle between
/// view and fur, and the bending of the skin over the fur's length, because a thick shell continues straight; shells
/// need not be closer than a pixel. Continuous in all arguments except the number of shells.
float shell_lod(const ShellView& view, const ShellVertex& vertex);

/// Returns for each vertex the mean over its edges of the change of the normal over the edge's length, 1 / sizes.
std::vector<float> curvatures(std::span<const glm::vec3> positions, std::span<const glm::vec3> normals,
                              std::span<const glm::uvec3> triangles);

/// Triangles to draw from a viewpoint, as indices of vertices. [lod] has the triangles for shells that are gone from
/// lod + 1 on. A view's last list has all triangles, and serves the shells that always remain.
struct ShellLists {
  using OfLods = std::array<std::vector<glm::uvec3>, max_shell_lod + 1>;
  OfLods facing, back_facing;  // back-facing ones only near silhouettes; the others lie behind the skin
};

struct ShellMesh {
  std::span<const glm::uvec3> triangles;
  std::span<const glm::vec3> centroids, normals;  // for each triangle; normals of any length
  std::span<const glm::vec3> positions;           // for each vertex
  std::span<const float> lods;
};

ShellLists sort_triangles(const ShellMesh& mesh, const ShellView& view);

}  // namespace pelage
