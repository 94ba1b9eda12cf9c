// What hardly belongs to a model: vertices far from all others, and parts too small to see.
#pragma once

#include "server/surface/faces.h"
#include "server/surface/weld.h"

namespace pelage {

struct Outliers {
  std::size_t far_vertices = 0;  // farther from the box of nine tenths of the vertices than three times its diagonal
  std::size_t far_parts = 0;     // of which all of the box lies so far
  std::size_t tiny_parts = 0;  // smaller than a thousandth of the diagonal of the box of nine tenths; of several parts
};

/// There is at least one vertex.
Outliers find_outliers(const Soup& soup, const Orientation& orientation);

}  // namespace pelage
