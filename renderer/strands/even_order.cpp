#include "renderer/strands/even_order.h"

#include <algorithm>
#include <bit>

namespace pelage {

namespace {

/// Spreads the lower 21 bits of x to every third bit of the result.
std::uint64_t spread_bits(std::uint64_t x) {
  x &= 0x1fffff;
  x = (x | x << 32) & 0x1f00000000ffff;
  x = (x | x << 16) & 0x1f0000ff0000ff;
  x = (x | x << 8) & 0x100f00f00f00f00f;
  x = (x | x << 4) & 0x10c30c30c30c30c3;
  return (x | x << 2) & 0x1249249249249249;
}

std::uint32_t reversed(std::uint32_t x, int bits) {
  std::uint32_t result = 0;
  for (int i = 0; i < bits; ++i, x >>= 1) result = result << 1 | (x & 1);
  return result;
}

}  // namespace

std::uint64_t morton_code(glm::dvec3 position) {
  const glm::dvec3 cell = glm::clamp((position + 1.0) * 0x1p20, 0.0, 0x1p21 - 1);
  return spread_bits(static_cast<std::uint64_t>(cell.x)) | spread_bits(static_cast<std::uint64_t>(cell.y)) << 1 |
         spread_bits(static_cast<std::uint64_t>(cell.z)) << 2;
}

EvenOrder even_order(std::span<const glm::vec3> roots) {
  struct Placed {
    std::uint64_t code;
    std::uint32_t root;
  };
  const auto count = static_cast<std::uint32_t>(roots.size());
  std::vector<Placed> along(count);
  for (std::uint32_t i = 0; i < count; ++i) along[i] = {morton_code(roots[i]), i};
  std::sort(along.begin(), along.end(),
            [](const Placed& a, const Placed& b) { return a.code != b.code ? a.code < b.code : a.root < b.root; });
  const int bits = count > 1 ? std::bit_width(count - 1) : 0;
  EvenOrder even;
  even.order.reserve(count), even.neighbour.reserve(count);
  std::vector<std::uint32_t> rank(count);  // index in the order, by position on the curve
  for (std::uint64_t i = 0; count > 0 && i < std::uint64_t{1} << bits; ++i) {
    const std::uint32_t at = reversed(static_cast<std::uint32_t>(i), bits);
    if (at >= count) continue;
    rank[at] = static_cast<std::uint32_t>(even.order.size());
    even.neighbour.push_back(rank[at & (at - 1)]);  // without its lowest set bit: that one came earlier
    even.order.push_back(along[at].root);
  }
  return even;
}

}  // namespace pelage
