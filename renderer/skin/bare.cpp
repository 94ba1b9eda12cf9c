#include "renderer/skin/bare.h"

#include <cmath>

namespace pelage {

namespace {

/// Rises smoothly from 0 at `low` to 1 at `high`; a step if they are equal.
double rise(double low, double high, double x) {
  if (high <= low) return x >= high ? 1 : 0;
  return glm::smoothstep(low, high, x);
}

}  // namespace

double bare_share(const FurSkinRegion& region, glm::dvec3 position, glm::dvec3 normal) {
  const double radii_off = glm::length(region.to_unit * (position - region.centre));
  if (radii_off > 1 + region.softness) return 0;
  const double inside = radii_off <= 1 ? 1 : 1 - rise(1, 1 + region.softness, radii_off);
  return inside * rise(region.cosine_none, region.cosine_full, glm::dot(normal, region.facing));
}

double fur_share(std::span<const FurSkinRegion> regions, glm::dvec3 position, glm::dvec3 normal) {
  double remaining = 1;
  for (const FurSkinRegion& region : regions) remaining *= 1 - bare_share(region, position, normal);
  return remaining;
}

}  // namespace pelage
