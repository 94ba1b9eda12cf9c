// Distances along the surface by the heat method.
#pragma once

#include <memory>
#include <span>
#include <vector>

#include "server/surface/geodesics.h"

namespace pelage {

/// The heat method (Crane et al. 2013) with cotangent weights: heat flows from the sources for a short while, and the
/// distance is the function whose gradient best points away along it. It converges to the distance along the surface
/// as the mesh gets finer; about 1 % off on meshes of even triangles. Factorises two matrices when it is made (Eigen's
/// sparse Cholesky), after which each set of sources is quick. Degenerate triangles conduct nothing.
class HeatDistance {
 public:
  explicit HeatDistance(const Surface& surface);
  ~HeatDistance();

  /// For each vertex, sizes; infinite on connected parts without a source. The sources' own distances are kept.
  std::vector<double> operator()(std::span<const SpreadSource> sources) const;

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace pelage
