// Grows strands along curves, which have knots and styles of their own.
#include <algorithm>
#include <cstddef>
#include <glm/glm.hpp>

#include "renderer/curves/curve_strips.h"
#include "renderer/strands/grow.h"

namespace pelage {

StrandSet grow_curves(std::span<const FurCurves> curves) {
  const CurveStrips strips = make_strips(curves);
  StrandSet set;
  set.segments = curve_segments;
  set.points.reserve(strips.points.size()), set.colours.reserve(strips.points.size());
  for (std::size_t i = 0; i < strips.styles.size(); ++i) {
    const CurveStyle& style = strips.styles[i];
    for (int k = 0; k <= curve_segments; ++k) {
      const glm::vec4 look = glm::mix(style.root, style.tip, static_cast<float>(k) / curve_segments);
      const glm::vec3 position = strips.points[i * (curve_segments + 1) + static_cast<std::size_t>(k)];
      set.points.push_back({position, std::max(0.5f * look.w, min_strand_radius)});
      set.colours.push_back(pack_colour(glm::vec3(look)));
    }
    set.roots.push_back({.normal = glm::vec3(style.normal), .number = style.normal.w});
  }
  return set;
}

}  // namespace pelage
