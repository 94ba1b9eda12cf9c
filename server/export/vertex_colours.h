// The colours of fur at the vertices of the mesh: the means of the strands that grow around them, so that patterns,
// paint and the model's own colours are in them.
#pragma once

#include <array>
#include <glm/glm.hpp>
#include <vector>

#include "server/export/strands.h"
#include "server/surface/surface.h"

namespace pelage {

class VertexColours {
 public:
  /// Takes the colours of the fur's strands; whiskers do not count.
  VertexColours(const Surface& surface, const ExportedStrands& strands);

  /// Returns the linear colour at a height s in [0, 1] of the fur. Where no strand grows it is the mean of all.
  glm::vec3 at(std::uint32_t vertex, double s) const;

 private:
  static constexpr std::size_t heights = 4;  // 0, 1/3, 2/3, 1
  using Ramp = std::array<glm::vec4, heights>;

  void add(const StrandSet& set, const Surface& surface);

  std::vector<Ramp> ramps_;  // sums, with their weights
  Ramp all_{};
};

}  // namespace pelage
