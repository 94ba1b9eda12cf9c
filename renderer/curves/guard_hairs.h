// Where guard hairs grow: single hairs that stand out of the fur, spread over a model once and chosen for each view.
#pragma once

#include <cstddef>
#include <cstdint>
#include <glm/glm.hpp>
#include <span>
#include <vector>

namespace pelage {

/// Render vertices of a model, and the model's own vertex of each. A triangle of the surface may come as several
/// pieces.
struct HairMesh {
  std::span<const glm::vec3> positions, normals;
  std::span<const glm::uvec3> triangles;
  std::span<const std::uint32_t> welded;
};

/// The root of a guard hair on a triangle. hair.vert mirrors it.
struct HairRoot {
  glm::uvec3 corners{0};   // render vertices
  std::uint32_t bits = 0;  // random
  glm::vec3 weights{0};    // of the corners, sum 1
  float padding = 0;

  /// Ten bits of the random number, [0, 1].
  float number(int shift) const { return static_cast<float>(bits >> shift & 1023u) / 1023; }
  bool operator==(const HairRoot&) const = default;
};
static_assert(sizeof(HairRoot) == 32);

/// Roots spread evenly over the surface's area; deterministic. Empty for a surface without area.
std::vector<HairRoot> scatter_hairs(const HairMesh& mesh, int count);

inline constexpr int hair_segments = 10;
/// What faces the camera by less than this cosine is drawn, fading in from there on. hair.vert holds the same.
inline constexpr float hair_limit = 0.6f;

/// What a view shows, far things first. The first `back_facing` stand on skin that faces away.
struct ShownHairs {
  std::vector<HairRoot> roots;
  std::size_t back_facing = 0;
};
ShownHairs shown_hairs(const HairMesh& mesh, std::span<const HairRoot> roots, glm::vec3 viewpoint);

}  // namespace pelage
