// Computes the colours of fur at the vertices of the mesh: the means of the strands that grow around them, so that they
// include patterns, paint and the model's own colours.
#pragma once

#include <array>
#include <glm/glm.hpp>
#include <span>
#include <vector>

#include "server/export/strands.h"
#include "server/surface/surface.h"

namespace pelage {

class VertexColours {
 public:
  /// Averages the colours of the strands of one coat, a number below strands.coats().
  VertexColours(const Surface& surface, const ExportedStrands& strands, std::size_t coat);
  /// Averages those of all coats of one surface, at least one.
  explicit VertexColours(std::span<const VertexColours> coats);

  /// Returns the linear colour at a height s in [0, 1] of the fur. Where no strand grows it is the mean of all.
  glm::vec3 at(std::uint32_t vertex, double s) const;

 private:
  static constexpr std::size_t heights = 4;  // 0, 1/3, 2/3, 1
  using Ramp = std::array<glm::vec4, heights>;

  void add(const StrandSet& set, const Surface& surface);
  void sum_all();

  std::vector<Ramp> ramps_;  // for each vertex: weighted sums of colours, and of weights in w
  Ramp all_{};
};

/// Returns the colours of each coat of the strands.
std::vector<VertexColours> colours_of_coats(const Surface& surface, const ExportedStrands& strands);

}  // namespace pelage
