// Strands of a coat as they stand on the surface: what the grower makes and the tracer reads.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <glm/glm.hpp>
#include <vector>

namespace pelage {

/// A place on a strand's axis and how thick the strand is there, sizes. The layout is what Embree reads.
struct StrandPoint {
  glm::vec3 place{0};
  float radius = 0;
};
static_assert(sizeof(StrandPoint) == 16);

/// What all points of a strand share.
struct StrandRoot {
  glm::vec3 normal{0, 1, 0};             // of the skin, unit
  float number = 0;                      // [0, 1)
  float reach = 1;                       // height s of the tip in the fur, (0, 1]; that of the root is 0
  float stretch = 1;                     // factor on the curve in which fur leans there
  float wetness = 0;                     // painted beyond the coat's own, [0, 1]
  std::uint32_t piece = no_piece;        // of the model that it stands on
  std::array<std::uint16_t, 2> share{};  // of the piece's second and third corner there, over 65535

  static constexpr std::uint32_t no_piece = ~std::uint32_t{0};
};
static_assert(sizeof(StrandRoot) == 36);

/// Linear colour in 4 bytes, 10 bits a channel over [0, 4] by their square roots.
std::uint32_t pack_colour(glm::vec3 colour);
glm::vec3 unpack_colour(std::uint32_t packed);

/// Strands with `segments` segments each: strand i has the points from i (segments + 1) on, root first. Any first part
/// of them lies evenly over the skin (EvenOrder).
struct StrandSet {
  int segments = 1;
  std::vector<StrandPoint> points;
  std::vector<std::uint32_t> colours;     // of each point; pack_colour
  std::vector<StrandRoot> roots;          // of each strand
  std::vector<std::uint32_t> neighbour;   // of each strand an earlier one that lies near; of the first itself
  std::vector<StrandPoint> closing = {};  // where the points are when the shutter closes; empty: they stay
  // For each strand, the factor from its colour to that of the mean strand in its place, packed by pack_colour.
  // Empty: strands are seen one by one.
  std::vector<std::uint32_t> to_mean = {};

  std::size_t count() const { return roots.size(); }
  std::size_t bytes() const;
};

}  // namespace pelage
