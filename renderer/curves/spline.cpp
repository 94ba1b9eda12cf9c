#include "renderer/curves/spline.h"

#include <algorithm>
#include <cassert>

namespace pelage {

glm::dvec3 spline_point(std::span<const glm::dvec3> points, double t) {
  assert(points.size() >= 2);
  const std::size_t last = points.size() - 1;
  const double along = std::clamp(t, 0.0, 1.0) * static_cast<double>(last);
  const std::size_t i = std::min(static_cast<std::size_t>(along), last - 1);
  const double x = along - static_cast<double>(i);
  const glm::dvec3 b = points[i], c = points[i + 1];
  const glm::dvec3 a = i > 0 ? points[i - 1] : 2.0 * b - c, d = i + 2 <= last ? points[i + 2] : 2.0 * c - b;
  if (x == 1) return c;
  return b + 0.5 * x * (c - a + x * (2.0 * a - 5.0 * b + 4.0 * c - d + x * (3.0 * (b - c) + d - a)));
}

}  // namespace pelage
