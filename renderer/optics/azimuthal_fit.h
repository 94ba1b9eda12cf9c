// The azimuthal part of the fibre models in a form that takes few reads: a polynomial in the absorption for each node
// of the other two axes.
#pragma once

#include <cstdint>
#include <vector>

#include "renderer/shading/scattering_table.h"

namespace pelage {

/// R does not depend on the absorption. Each other lobe is t (c1 + c2 t + c3 t^2) of the absorption coordinate t, by
/// least squares over the table's nodes: within 2% of the root mean square of TT, 5% of the others, which are a fifth
/// of it.
struct AzimuthalFit {
  static constexpr int words = 5;   // of a node: R and TT c1; TT c2, c3; TRT c1, c2; TRT c3 and rest c1; rest c2, c3
  static constexpr int beyond = 2;  // words behind the last node, which reads of four at a time touch
  int azimuths = 0, inclinations = 0;
  std::vector<std::int32_t> nodes;  // words of node (i, j) at (j azimuths + i) words: two bfloat16, the first lower
};

/// Empty for an empty table.
AzimuthalFit fit_azimuthal(const ScatteringTable& table);

}  // namespace pelage
