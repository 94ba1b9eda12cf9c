// Which triangles are drawn in how many layers for one view: non-uniform layers (fur modelling 2; science.md 1).
//
// There are three sets of layers: a quarter, half and all of the shells. A vertex's level says how many it needs, as a
// continuous number; between two sets both are drawn with shares of the optical depth that add up to 1. So the opacity
// stays true, no crack opens between triangles, and nothing pops when the camera moves.
#pragma once

#include <array>
#include <cstdint>
#include <glm/glm.hpp>
#include <span>
#include <vector>

#include "protocol/commands/frame.h"

namespace pelage {

inline constexpr int layer_sets = 3;

/// Shells of a set when the full one has `shells`: at least 1.
int shells_of_set(int shells, int set);

/// Texture steps inside each layer of a set when the full one takes `steps`: thicker layers take more.
int steps_of_set(int steps, int set);

/// Cosine between view and normal: fur on triangles turned further away lies behind the skin that faces the eye, but for
/// long fur on thin parts.
inline constexpr float furthest_averted = -0.6f;

struct LayerView {
  glm::vec3 eye{0};
  float pixel = 0;  // size of a pixel at distance 1
  int shells = 16;
  ShellPolicy policy = ShellPolicy::adaptive;
  float furthest = furthest_averted;  // cosine from which on triangles are drawn; -2 draws all
};

/// What a vertex brings: `length` of its fur in sizes, `curvature` of the skin in 1 / sizes.
struct LayerVertex {
  glm::vec3 position{0}, normal{0, 0, 1};
  float length = 0, curvature = 0;
};

/// Level of a vertex in [0, layer_sets - 1]: layers follow the tangent of the angle between view and fur and the
/// bending of the skin over the fur's length, as a thick layer goes straight on; they need not lie closer than a pixel.
/// Continuous in all of its arguments.
float layer_level(const LayerView& view, const LayerVertex& vertex);

/// Mean over the edges at each vertex of the change of the normal over the edge's length, 1 / sizes.
std::vector<float> curvatures(std::span<const glm::vec3> positions, std::span<const glm::vec3> normals,
                              std::span<const glm::uvec3> triangles);

/// Share of the optical depth that a set draws at a level; the shares of all sets add up to 1. fur.vert has the same.
float set_share(float level, int set);

/// Triangles of one set as seen from an eye, as indices of vertices.
struct LayerTriangles {
  std::vector<glm::uvec3> facing, averted;  // averted only near outlines: further away they lie behind the skin
};
using LayerLists = std::array<LayerTriangles, layer_sets>;

struct LayerMesh {
  std::span<const glm::uvec3> triangles;
  std::span<const glm::vec3> centroids, normals;  // of triangles; normals of any length
  std::span<const float> levels;                  // of vertices
};

/// Every triangle goes to each set that has a share at one of its corners.
LayerLists sort_triangles(const LayerMesh& mesh, glm::vec3 eye, float furthest = furthest_averted);

/// The triangles that are in some set. Nothing else may write the depth of dense fur, or thin parts show holes where
/// fur that is not drawn hides what is.
std::vector<glm::uvec3> shown_triangles(const LayerMesh& mesh, glm::vec3 eye);

}  // namespace pelage
