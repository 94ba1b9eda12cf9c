// Finds parts of a mesh that probably do not belong to the model: vertices far from all others, and tiny parts.
#pragma once

#include "server/surface/faces.h"
#include "server/surface/weld.h"

namespace pelage {

struct Outliers {
  std::size_t far_vertices = 0;  // farther than 3 diagonals from the bulk box, which holds nine tenths along each axis
  std::size_t far_parts = 0;     // parts whose whole box is that far away
  std::size_t tiny_parts = 0;    // parts smaller than a thousandth of the bulk box's diagonal; 0 for a single part
};

/// Requires at least one vertex.
Outliers find_outliers(const Soup& soup, const Orientation& orientation);

}  // namespace pelage
