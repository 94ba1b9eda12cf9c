#include "server/surface/outliers.h"

#include <algorithm>

namespace pelage {

namespace {

/// Returns the box that leaves out a twentieth of the vertices at either end of each axis.
Placement bulk_of(const std::vector<glm::dvec3>& positions) {
  const std::size_t cut = positions.size() / 20;
  glm::dvec3 low, high;
  std::vector<double> line(positions.size());
  for (int axis = 0; axis < 3; ++axis) {
    std::transform(positions.begin(), positions.end(), line.begin(), [&](const glm::dvec3& p) { return p[axis]; });
    std::nth_element(line.begin(), line.begin() + static_cast<std::ptrdiff_t>(cut), line.end());
    low[axis] = line[cut];
    const std::size_t last = line.size() - 1 - cut;
    std::nth_element(line.begin(), line.begin() + static_cast<std::ptrdiff_t>(last), line.end());
    high[axis] = line[last];
  }
  return placement_of({low, high});
}

/// Returns the distance between two boxes.
double distance(const Placement& bulk, glm::dvec3 low, glm::dvec3 high) {
  return glm::length(glm::max(glm::max(low - bulk.high, bulk.low - high), glm::dvec3(0)));
}

}  // namespace

Outliers find_outliers(const Soup& soup, const Orientation& orientation) {
  constexpr double far = 3, tiny = 1e-3;  // relative to the size of the bulk
  const Placement bulk = bulk_of(soup.positions);
  Outliers outliers;
  if (!(bulk.size > 0)) return outliers;
  for (const glm::dvec3& p : soup.positions) outliers.far_vertices += distance(bulk, p, p) > far * bulk.size ? 1 : 0;
  if (orientation.parts.size() < 2) return outliers;
  for (const OrientedPart& part : orientation.parts) {
    outliers.far_parts += distance(bulk, part.box.low, part.box.high) > far * bulk.size ? 1 : 0;
    outliers.tiny_parts += part.box.size < tiny * bulk.size ? 1 : 0;
  }
  return outliers;
}

}  // namespace pelage
