// Blending what several sources say, by Gaussian weights of their distances (fur modelling 5.1).
#pragma once

#include <optional>
#include <span>
#include <vector>

#include "protocol/commands/tools.h"
#include "server/surface/heat_distance.h"
#include "server/surface/spread.h"

namespace pelage {

/// Distances and directions from sources, by the distance that a command names. Directions go the way of Dijkstra's
/// search where they do not go straight. Calls may run in parallel.
class Spreader {
 public:
  Spreader(const Surface& surface, DistanceKind kind);
  Spread operator()(std::span<const SpreadSource> sources) const;

 private:
  const Surface& surface_;
  DistanceKind kind_;
  std::optional<HeatDistance> heat_;
};

/// exp(-d^2 / (2 sigma^2)) for each distance, over their sum. The largest exponent is taken off first, so that far from
/// all sources the sum is not 0 / 0 (science.md 3). All 0 where every distance is infinite.
void gaussian_weights(std::span<const double> distances, double sigma, std::span<double> weights);

}  // namespace pelage
