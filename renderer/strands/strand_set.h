// Strands of a coat on the surface, which the grower makes and the tracer reads.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <glm/glm.hpp>
#include <vector>

namespace pelage {

/// A position on a strand's axis and the strand's radius there, sizes. Embree reads this memory layout.
struct StrandPoint {
  glm::vec3 position{0};
  float radius = 0;
};
static_assert(sizeof(StrandPoint) == 16);

/// Attributes that all points of a strand share.
struct StrandRoot {
  glm::vec3 normal{0, 1, 0};             // of the skin, unit
  float number = 0;                      // random number of the strand, [0, 1)
  float reach = 1;                       // height s of the tip in the fur, (0, 1]; that of the root is 0
  float stretch = 1;                     // factor on the lean curve of the fur
  float wetness = 0;                     // painted beyond the coat's own, [0, 1]
  std::uint32_t triangle = no_triangle;  // index of the model's triangle under the root
  std::array<std::uint16_t, 2> share{};  // barycentric coordinates for its second and third corner, times 65535

  static constexpr std::uint32_t no_triangle = ~std::uint32_t{0};
};
static_assert(sizeof(StrandRoot) == 36);

/// Packs a linear colour into 4 bytes: 10 bits for the square root of each channel, over [0, 4].
std::uint32_t pack_colour(glm::vec3 colour);
glm::vec3 unpack_colour(std::uint32_t packed);

/// Strands with `segments` segments each: strand i has the points from i (segments + 1) on, root first. Every prefix of
/// them is spread evenly over the skin (EvenOrder).
struct StrandSet {
  int segments = 1;
  std::vector<StrandPoint> points;
  std::vector<std::uint32_t> colours;     // for each point; pack_colour
  std::vector<StrandRoot> roots;          // for each strand
  std::vector<std::uint32_t> neighbour;   // for each strand, the index of an earlier one near it; 0 for the first
  std::vector<StrandPoint> closing = {};  // the points when the shutter closes; empty if they do not move
  // For each strand, the factor from its colour to that of the mean strand at its position, packed by pack_colour.
  // Empty: each strand always shows its own colour.
  std::vector<std::uint32_t> to_mean = {};

  std::size_t count() const { return roots.size(); }
  std::size_t bytes() const;
};

}  // namespace pelage
