// The order of strands in which any first part of them lies evenly over the skin.
#pragma once

#include <cstdint>
#include <glm/glm.hpp>
#include <span>
#include <vector>

namespace pelage {

/// Place along a Z curve (Morton 1966) through [-1, 1]^3, in which a model of diagonal 1 about the origin lies.
std::uint64_t place_on_curve(glm::dvec3 place);

/// Indices of `roots`, sizes, in the order in which strands are kept: along a Z curve with its bits reversed (van der
/// Corput 1935), so that each first part of n leaves gaps of at most twice their mean on the curve. Deterministic.
struct EvenOrder {
  std::vector<std::uint32_t> order;
  /// For each root but the first in that order, an earlier root near it: the last one before it on the curve among the
  /// roots that come earlier in the order. The first root is its own neighbour.
  std::vector<std::uint32_t> neighbour;
};
EvenOrder even_order(std::span<const glm::vec3> roots);

}  // namespace pelage
