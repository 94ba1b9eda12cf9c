#include "renderer/pattern/tufts.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "renderer/pattern/cells.h"

namespace pelage {

namespace {

constexpr std::uint32_t tuft_stream = 31;
constexpr float finer = 0.45f, max_gathered = 0.6f;

constexpr std::size_t beside = 27, looked_at = 28;  // cells around a position, and their number in whole vectors

/// Returns the offsets of the cells around a position along one axis: -1, 0 or 1.
constexpr std::array<std::int8_t, looked_at> steps_along(int axis) {
  std::array<std::int8_t, looked_at> steps{};
  constexpr std::array<int, 3> every{1, 3, 9};
  for (std::size_t k = 0; k < beside; ++k)
    steps[k] = static_cast<std::int8_t>(static_cast<int>(k) / every[static_cast<std::size_t>(axis)] % 3 - 1);
  return steps;
}
constexpr std::array steps{steps_along(0), steps_along(1), steps_along(2)};

/// Returns the tuft on one scale, in units of its cells. Distances off the surface count three times.
TuftPull nearest_tuft(glm::vec3 position, glm::vec3 normal, std::uint32_t stream, std::uint32_t seed) {
  const glm::vec3 low = glm::floor(position), inside = position - low;
  const glm::uvec3 cell(static_cast<glm::ivec3>(low));
  Cells<looked_at> cells;
  for (std::size_t k = 0; k < looked_at; ++k) {
    cells.x[k] = cell.x + static_cast<std::uint32_t>(steps[0][k]);
    cells.y[k] = cell.y + static_cast<std::uint32_t>(steps[1][k]);
    cells.z[k] = cell.z + static_cast<std::uint32_t>(steps[2][k]);
  }
  CellNumbers<looked_at> to = numbers_of(cells, stream, seed);
  std::array<float, looked_at> squared;
  for (std::size_t k = 0; k < looked_at; ++k) {
    const float x = to.x[k] += steps[0][k] - inside.x, y = to.y[k] += steps[1][k] - inside.y;
    const float z = to.z[k] += steps[2][k] - inside.z, off = x * normal.x + y * normal.y + z * normal.z;
    squared[k] = x * x + y * y + z * z + 8 * off * off;
  }
  std::size_t nearest = 0;
  for (std::size_t k = 1; k < beside; ++k)
    if (squared[k] < squared[nearest]) nearest = k;
  float next = std::numeric_limits<float>::max();
  for (std::size_t k = 0; k < beside; ++k)
    if (k != nearest) next = std::min(next, squared[k]);
  const float first = std::sqrt(squared[nearest]), second = std::sqrt(next);
  const glm::vec3 apart(to.x[nearest], to.y[nearest], to.z[nearest]);
  return {apart - glm::dot(apart, normal) * normal, (second - first) / std::max(second + first, 1e-6f)};
}

}  // namespace

TuftPull tuft_at(const Tufts& tufts, glm::vec3 root, glm::vec3 normal) {
  TuftPull sum;
  float size = static_cast<float>(tufts.size), weight = 1;
  for (int scale = 0; scale < tufts.scales; ++scale) {
    const TuftPull tuft =
        nearest_tuft(root / size, normal, tuft_stream + static_cast<std::uint32_t>(scale), tufts.seed);
    sum.to_middle += weight * size * tuft.to_middle;
    sum.inside = std::min(sum.inside, glm::mix(1.0f, tuft.inside, weight));
    size *= finer, weight *= 0.5f;
  }
  const float length = glm::length(sum.to_middle), longest = longest_pull(tufts);
  if (length > longest) sum.to_middle *= longest / length;
  return sum;
}

float longest_pull(const Tufts& tufts) { return 1.2f * static_cast<float>(tufts.size); }

float gathered(const Tufts& tufts, float s) {
  return max_gathered * static_cast<float>(tufts.gather) * s * std::sqrt(s);
}

}  // namespace pelage
