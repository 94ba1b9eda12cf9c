#include "server/groom/keys.h"

#include <algorithm>
#include <cassert>
#include <cmath>

namespace pelage {

Spreader::Spreader(const Surface& surface, DistanceKind kind) : surface_(surface), kind_(kind) {
  if (kind == DistanceKind::heat) heat_.emplace(surface);
}

Spread Spreader::operator()(std::span<const SpreadSource> sources) const {
  if (kind_ == DistanceKind::straight) return spread_through_space(surface_, sources);
  Spread spread = spread_along_edges(surface_, sources);
  if (heat_) spread.distance = (*heat_)(sources);
  return spread;
}

void gaussian_weights(std::span<const double> distances, double sigma, std::span<double> weights) {
  assert(distances.size() == weights.size() && sigma > 0);
  const double nearest = *std::min_element(distances.begin(), distances.end());
  std::fill(weights.begin(), weights.end(), 0.0);
  if (!std::isfinite(nearest)) return;
  double sum = 0;
  for (std::size_t i = 0; i < distances.size(); ++i) {
    if (!std::isfinite(distances[i])) continue;
    // (d^2 - n^2) / sigma^2 as a product, which does not cancel where both are large
    const double over = (distances[i] - nearest) / sigma * ((distances[i] + nearest) / sigma);
    sum += weights[i] = std::exp(-0.5 * over);
  }
  for (double& weight : weights) weight /= sum;
}

}  // namespace pelage
