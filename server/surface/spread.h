// Distances over the whole surface from a set of sources, and directions brought along the way.
#pragma once

#include <cstdint>
#include <glm/glm.hpp>
#include <span>
#include <vector>

#include "server/surface/surface.h"

namespace pelage {

/// A place that distances count from.
struct SpreadSource {
  std::uint32_t vertex = 0;
  double distance = 0;   // of the vertex itself from the source
  glm::dvec3 vector{0};  // in the vertex's tangent plane
};

struct Spread {
  std::vector<double> distance;    // for each vertex, sizes; infinite where no way leads
  std::vector<glm::dvec3> vector;  // the nearest source's, brought there by smallest rotations along the way
};

/// Dijkstra along edges (fur modelling 5.1). Overestimates the distance along the surface, and refining the mesh does
/// not cure that. Lengths of edges are found once for all searches, which may run in parallel. Of several shortest ways
/// to a vertex, the one whose last step begins nearest to its source counts, and of those the one from the lowest
/// vertex.
class EdgeSearch {
 public:
  explicit EdgeSearch(const Surface& surface);
  Spread operator()(std::span<const SpreadSource> sources) const;

 private:
  const Surface& surface_;
  std::vector<double> lengths_;  // of the edges in the order of Surface::adjacency
  double mean_ = 0, longest_ = 0;
};

/// One search.
Spread spread_along_edges(const Surface& surface, std::span<const SpreadSource> sources);

/// Through space, to the nearest source; the vector is brought there in one rotation.
Spread spread_through_space(const Surface& surface, std::span<const SpreadSource> sources);

}  // namespace pelage
