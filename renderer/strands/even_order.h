// An order of strands in which every prefix is spread evenly over the skin.
#pragma once

#include <cstdint>
#include <glm/glm.hpp>
#include <span>
#include <vector>

namespace pelage {

/// Position along a Z curve (Morton 1966) through [-1, 1]^3, which contains a model of diagonal 1 centred on the
/// origin.
std::uint64_t morton_code(glm::dvec3 position);

/// Indices of `roots` (positions in sizes), in the order in which strands are kept: along a Z curve with its bits
/// reversed (van der Corput 1935), so that the first n roots leave gaps of at most twice their mean on the curve.
/// Deterministic.
struct EvenOrder {
  std::vector<std::uint32_t> order;
  /// For each root in that order, the index in `order` of an earlier root near it: of the roots that come earlier in
  /// the order, the last one before it on the curve. The first root is its own neighbour.
  std::vector<std::uint32_t> neighbour;
};
EvenOrder even_order(std::span<const glm::vec3> roots);

}  // namespace pelage
