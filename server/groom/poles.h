// Finds where the fur of a body begins and ends: under the chin, and at the ends of limbs, ears and tail.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "server/groom/cancel.h"
#include "server/surface/adjacency.h"
#include "server/surface/mesh.h"

namespace pelage {

/// A vertex that fur flows out of (flux above 0) or into (below 0).
struct Pole {
  std::uint32_t vertex = 0;
  double flux = 0;
};

/// Finds the poles of parts, one after the other. The parts share the finder's storage. All of them together take the
/// time of one walk over the mesh, because no vertex is near two ends.
class PoleFinder {
 public:
  /// Keeps references to all three arguments.
  PoleFinder(const Mesh& mesh, const Adjacency& edges, const Cancel& cancel);

  /// Returns the poles of one connected part that faces +Z; `part` holds its vertices, sorted. Fur begins under the
  /// chin: at the lowest vertices near the position that is farthest forward and up. It ends near each vertex whose
  /// distance from the chin along edges exceeds that of its surroundings by a tenth of the part's size; of the vertices
  /// near such a peak it uses those least visible, low and at the back. The fluxes sum to 0; of vertices that mirror
  /// each other across the middle, both share one. Empty for a part without an end. Throws Cancelled.
  std::vector<Pole> find(std::span<const std::uint32_t> part);

 private:
  struct Peak;
  using Vertices = std::vector<std::uint32_t>;

  /// Dijkstra's search along edges; holds the distances from the sources of the last call.
  class Walk {
   public:
    Walk(const Mesh& mesh, const Adjacency& edges, const Cancel& cancel);
    /// Returns the vertices at most `farthest` away from the sources, sorted.
    const Vertices& from(std::span<const std::uint32_t> sources, double farthest);
    double operator[](std::uint32_t vertex) const { return distances_[vertex]; }

   private:
    const Mesh& mesh_;
    const Adjacency& edges_;
    const Cancel& cancel_;
    std::vector<double> distances_;  // by vertex of the mesh; infinite if not reached
    Vertices reached_;
  };

  Vertices chin_of(std::span<const std::uint32_t> part, double size);
  std::vector<Peak> peaks_of(std::span<const std::uint32_t> part);
  Vertices hidden_end(const Peak& peak, double size);

  const Mesh& mesh_;
  const Adjacency& edges_;
  Walk from_chin_, near_;
  Vertices peak_;  // union-find parents of the vertices visited so far by peaks_of
};

}  // namespace pelage
