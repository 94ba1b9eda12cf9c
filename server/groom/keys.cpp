#include "server/groom/keys.h"

namespace pelage {

Spreader::Spreader(const Surface& surface, DistanceKind kind) : surface_(surface), kind_(kind) {
  if (kind != DistanceKind::straight) along_edges_.emplace(surface);
  if (kind == DistanceKind::heat) heat_.emplace(surface);
}

Spread Spreader::operator()(std::span<const SpreadSource> sources) const {
  if (kind_ == DistanceKind::straight) return spread_through_space(surface_, sources);
  Spread spread = (*along_edges_)(sources);
  if (heat_) spread.distance = (*heat_)(sources);
  return spread;
}

}  // namespace pelage
