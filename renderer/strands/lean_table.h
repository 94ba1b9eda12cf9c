// The lean curve (protocol/base/lean_curve.h) by inclination and height: strands need it at more places than can be
// worked out for each.
#pragma once

#include <array>
#include <glm/glm.hpp>
#include <vector>

#include "protocol/commands/coat.h"

namespace pelage {

inline constexpr int lean_cells = 32;  // between the heights that are kept

/// A place on the curve of a strand of length 1, (across, up), and how it moves with the height.
struct LeanKnot {
  glm::vec2 place{0}, slope{0};
};

/// At the heights i / lean_cells.
using LeanRow = std::array<LeanKnot, lean_cells + 1>;

class LeanTable {
 public:
  LeanTable(LeanCurve curve, double root_share);

  /// For an inclination in [0, 1]: off the curve by less than 1e-5 of its length, cubic in between.
  LeanRow row(float inclination) const;

 private:
  std::vector<LeanRow> rows_;
};

}  // namespace pelage
