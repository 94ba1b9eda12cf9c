// Where the fur of a body begins and where it ends: under the chin, and at the ends of limbs, ears and tail.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "server/groom/cancel.h"
#include "server/surface/adjacency.h"
#include "server/surface/mesh.h"

namespace pelage {

/// A place that fur flows out of (above 0) or into.
struct Pole {
  std::uint32_t vertex = 0;
  double flux = 0;
};

/// Finds the poles of parts, one after the other. The parts share its storage, and together take the time of one walk
/// over the mesh, because no vertex is near two ends.
class PoleFinder {
 public:
  /// All three are kept by reference.
  PoleFinder(const Mesh& mesh, const Adjacency& edges, const Cancel& cancel);

  /// Returns the poles of one connected part that looks along +Z; `part` holds its vertices, rising. Fur begins under
  /// the chin: at the lowest vertices near what lies farthest forward and up. It ends, on the side that is seen least,
  /// near each vertex whose distance from there along edges exceeds that of its surroundings by a tenth of the part's
  /// size. The fluxes sum to 0; equal positions on both sides of the middle share one. Empty for a part without an end.
  /// Throws Cancelled.
  std::vector<Pole> find(std::span<const std::uint32_t> part);

 private:
  struct Peak;
  using Vertices = std::vector<std::uint32_t>;

  /// Distances along edges from the sources of the last walk.
  class Walk {
   public:
    Walk(const Mesh& mesh, const Adjacency& edges, const Cancel& cancel);
    /// The vertices at most so far away, rising.
    const Vertices& from(std::span<const std::uint32_t> sources, double farthest);
    double operator[](std::uint32_t vertex) const { return distances_[vertex]; }

   private:
    const Mesh& mesh_;
    const Adjacency& edges_;
    const Cancel& cancel_;
    std::vector<double> distances_;  // by vertex of the mesh; infinite where not reached
    Vertices reached_;
  };

  Vertices chin_of(std::span<const std::uint32_t> part, double size);
  std::vector<Peak> peaks_of(std::span<const std::uint32_t> part);
  Vertices hidden_end(const Peak& peak, double size);

  const Mesh& mesh_;
  const Adjacency& edges_;
  Walk from_chin_, near_;
  Vertices peak_;  // union-find parents of the vertices visited so far, while peaks are found
};

}  // namespace pelage
