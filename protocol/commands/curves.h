// Whiskers, lashes and brows: a few guided curves that are placed in a scene, set by a command and logged.
#pragma once

#include <cstdint>
#include <glm/glm.hpp>
#include <vector>

namespace pelage {

/// Points in model coordinates, root first, 2 to 32. The curve passes through them (Catmull and Rom 1974).
using GuideCurve = std::vector<glm::dvec3>;

/// Curves of one kind. Guides are drawn as they are given; between each two that follow each other `fill` more are
/// mixed.
struct CurveGroup {
  std::vector<GuideCurve> curves;              // 1 to 4096 guides
  double width_root = 0.0008;                  // sizes, [0, 0.1]
  double width_tip = 0.0001;                   // sizes, [0, 0.1]
  glm::vec3 root_colour{0.55f, 0.50f, 0.44f};  // linear
  glm::vec3 tip_colour{0.80f, 0.77f, 0.72f};   // linear
  int fill = 0;                                // [0, 4095]
  double spread = 0;                           // how far filled curves stray in length, direction and place, [0, 1]
  std::uint32_t seed = 1;

  bool operator==(const CurveGroup&) const = default;
};

/// How many curves a group draws: its guides and what is filled in.
inline std::uint64_t curve_count(const CurveGroup& group) {
  const std::uint64_t guides = group.curves.size();
  return guides == 0 ? 0 : guides + (guides - 1) * static_cast<std::uint64_t>(group.fill);
}

}  // namespace pelage
