// The order in which strands are kept: any first part of them lies evenly over the skin.
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
  /// Of each but the first in that order, an earlier one that lies near: the last before it on the curve of those that
  /// were there when it came. Of the first itself.
  std::vector<std::uint32_t> neighbour;
};
EvenOrder even_order(std::span<const glm::vec3> roots);

}  // namespace pelage
