// Winding that agrees within each part and faces outwards.
#pragma once

#include "server/surface/soup.h"

namespace pelage {

struct Orientation {
  std::size_t flipped_triangles = 0;
  std::size_t open_edges = 0;          // of one triangle
  std::size_t non_manifold_edges = 0;  // of three triangles or more
  std::size_t one_sided_edges = 0;     // across which the winding cannot agree, as on a Moebius strip
};

/// Turns triangles so that neighbours across each edge of two triangles agree, and each such part encloses a positive
/// signed volume around the middle of its box. A part that encloses next to nothing (a plane) keeps the winding that
/// most of its area had. Deterministic.
Orientation orient(Soup& soup);

}  // namespace pelage
