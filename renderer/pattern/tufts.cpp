#include "renderer/pattern/tufts.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "renderer/pattern/pattern.h"

namespace pelage {

namespace {

constexpr std::uint32_t tuft_stream = 31;
constexpr float finer = 0.45f, max_gathered = 0.6f;

/// One scale, in units of its cells. What lies off the surface counts as three times as far.
TuftPlace nearest_tuft(glm::vec3 place, glm::vec3 normal, std::uint32_t stream, std::uint32_t seed) {
  const glm::ivec3 cell(glm::floor(place));
  float first = std::numeric_limits<float>::max(), second = first;
  TuftPlace tuft;
  for (int k = 0; k < 27; ++k) {
    const glm::ivec3 at = cell + glm::ivec3(k % 3 - 1, k / 3 % 3 - 1, k / 9 - 1);
    const glm::vec3 apart = glm::vec3(at) + random_of_cell(at, stream, seed) - place;
    const float off = glm::dot(apart, normal);
    const glm::vec3 along = apart - off * normal;
    const float distance = std::sqrt(glm::dot(along, along) + 9 * off * off);
    if (distance < first) {
      second = first, first = distance;
      tuft.to_middle = along;
    } else {
      second = std::min(second, distance);
    }
  }
  tuft.inside = (second - first) / std::max(second + first, 1e-6f);
  return tuft;
}

}  // namespace

TuftPlace tuft_at(const Tufts& tufts, glm::vec3 root, glm::vec3 normal) {
  TuftPlace sum;
  float size = static_cast<float>(tufts.size), weight = 1;
  for (int scale = 0; scale < tufts.scales; ++scale) {
    const TuftPlace tuft =
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
