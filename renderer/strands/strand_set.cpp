#include "renderer/strands/strand_set.h"

#include <cmath>

namespace pelage {

namespace {
constexpr float brightest = 4, steps = 1023;
}

std::uint32_t pack_colour(glm::vec3 colour) {
  const glm::vec3 share = glm::sqrt(glm::clamp(colour / brightest, 0.0f, 1.0f)) * steps + 0.5f;
  return static_cast<std::uint32_t>(share.r) | static_cast<std::uint32_t>(share.g) << 10 |
         static_cast<std::uint32_t>(share.b) << 20;
}

glm::vec3 unpack_colour(std::uint32_t packed) {
  const glm::vec3 share = glm::vec3(packed & 1023, packed >> 10 & 1023, packed >> 20 & 1023) / steps;
  return brightest * share * share;
}

std::size_t StrandSet::bytes() const {
  return points.size() * sizeof(StrandPoint) + colours.size() * sizeof(std::uint32_t) +
         roots.size() * sizeof(StrandRoot);
}

}  // namespace pelage
