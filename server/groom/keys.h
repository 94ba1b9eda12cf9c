// Blends values of several sources over the surface, by Gaussian weights of their distances (fur modelling 5.1).
#pragma once

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <span>
#include <vector>

#include "protocol/commands/tools.h"
#include "server/surface/geodesics.h"

namespace pelage {

/// Number of sources whose distances are computed at a time, so that memory does not grow with the number of sources.
inline constexpr std::size_t spread_batch_size = 16;

/// Computes distances and directions from sources, by the kind of distance that a command names. Directions follow the
/// paths of Dijkstra's search unless the distance is straight. Calls may run in parallel.
class Spreader {
 public:
  Spreader(const Surface& surface, DistanceKind kind);
  Spread operator()(std::span<const SpreadSource> sources) const;

 private:
  const Surface& surface_;
  DistanceKind kind_;
  std::optional<EdgeSearch> along_edges_;
  std::optional<HeatDistance> heat_;
};

/// Returns the influence of keys at a distance, [0, 1]: 1 up to half of their reach, 0 from their reach on.
inline double reach_falloff(std::optional<double> reach, double distance) {
  if (!reach) return 1;
  const double t = std::clamp(2 * distance / *reach - 1, 0.0, 1.0);
  return 1 - t * t * (3 - 2 * t);
}

/// The mean of values with weights exp(-d^2 / (2 sigma^2)) by their distances d. The largest exponent is factored out,
/// so that the mean is not 0 / 0 far from all sources (science.md 3). Values may be added in several portions.
template <class Value>
class GaussianMean {
 public:
  /// Adds the first `count` sources: value(k) at distance(k), which is infinite for sources without a value.
  template <class Distance, class ValueOf>
  void add(std::size_t count, double sigma, const Distance& distance, const ValueOf& value) {
    double nearest = nearest_;
    for (std::size_t k = 0; k < count; ++k) nearest = std::min(nearest, distance(k));
    if (!std::isfinite(nearest)) return;
    const double rescaled = weight_ > 0 ? weight_of(nearest_, nearest, sigma) : 0;
    weight_ *= rescaled, sum_ *= rescaled, nearest_ = nearest;
    for (std::size_t k = 0; k < count; ++k) {
      const double weight = weight_of(distance(k), nearest, sigma);
      if (weight > 0) weight_ += weight, sum_ += weight * value(k);
    }
  }

  /// Returns whether any source has a finite distance.
  bool reached() const { return weight_ > 0; }
  /// Returns the distance of the nearest source; infinite if there is none.
  double nearest() const { return nearest_; }
  /// Returns the mean. Requires reached().
  Value mean() const { return sum_ / weight_; }

 private:
  /// exp(-(d^2 - n^2) / (2 sigma^2)). The difference of squares is computed as a product, to avoid cancellation if both
  /// are large.
  static double weight_of(double distance, double nearest, double sigma) {
    constexpr double vanishing = 1500;  // exp(-750) underflows in double
    if (distance == nearest) return 1;
    const double over = (distance - nearest) / sigma * ((distance + nearest) / sigma);
    return over < vanishing ? std::exp(-0.5 * over) : 0;
  }

  double nearest_ = std::numeric_limits<double>::infinity(), weight_ = 0;
  Value sum_{0};
};

}  // namespace pelage
