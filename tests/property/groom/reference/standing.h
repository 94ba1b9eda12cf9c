// Fur as it stands, for brushes that reach it: a strand is a chain of eight straight segments.
#pragma once

#include <array>
#include <optional>
#include <vector>

#include "tests/property/groom/reference/body.h"

namespace pelage::plain {

/// Position on a strand of length 1 at arc length `s`: across and up (science.md 2).
dvec2 lean_position(const Coat& coat, double inclination, double s);

struct Standing {
  struct StrandPoint {
    dvec3 at;
    double lift;  // height over the skin, in strand lengths
  };
  using Strand = std::array<StrandPoint, 9>;
  std::vector<Strand> strands;  // by vertex; each from root to tip
};

/// Returns the strands if the brush reaches fur, and nothing if it reaches skin.
std::optional<Standing> standing_of(const Brush& brush, const Stage& stage, const Fur& fur);

/// The point of a strand that is nearest to `position`.
Standing::StrandPoint nearest_of(const Standing::Strand& strand, dvec3 position);

}  // namespace pelage::plain
