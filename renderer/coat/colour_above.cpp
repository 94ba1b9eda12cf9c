#include "renderer/coat/colour_above.h"

#include "renderer/coat/strand_tile.h"

namespace pelage {

std::array<glm::vec3, slice_count> colour_above(const Coat& coat) {
  std::array<glm::vec3, slice_count> result{};
  glm::dvec3 sum(0);
  for (int i = slice_count - 1; i >= 0; --i) {
    const glm::dvec3 here(ramp_colour(coat, (i + 0.5) / slice_count));
    sum += here;
    const glm::dvec3 mean = sum / static_cast<double>(slice_count - i);
    result[static_cast<std::size_t>(i)] = glm::clamp((mean + 1e-6) / (here + 1e-6), 0.0, 100.0);
  }
  return result;
}

}  // namespace pelage
