// Fur as it stands, for brushes that reach it: a strand is a chain of eight straight pieces.
#pragma once

#include <array>
#include <optional>
#include <vector>

#include "tests/property/groom/reference/body.h"

namespace pelage::plain {

/// The strand's place at a share of its length, for a strand of length 1: across and up (science.md 2).
dvec2 lean_place(const Coat& coat, double inclination, double s);

struct Standing {
  struct Place {
    dvec3 at;
    double lift;  // over the skin, in lengths of the strand
  };
  using Strand = std::array<Place, 9>;
  std::vector<Strand> strands;  // of each vertex, from root to tip
};

/// The fur where the brush reaches fur; nothing where it reaches skin.
std::optional<Standing> standing_of(const Brush& brush, const Stage& stage, const Fur& fur);

/// The place of a strand that is nearest to another.
Standing::Place nearest_of(const Standing::Strand& strand, dvec3 place);

}  // namespace pelage::plain
