// The azimuthal part of the fibre models in a form that needs few memory reads: a polynomial in the absorption for each
// node of the other two axes.
#pragma once

#include <cstdint>
#include <vector>

#include "renderer/shading/scattering_table.h"

namespace pelage {

/// R does not depend on the absorption. Each other lobe is t (c1 + c2 t + c3 t^2) in the absorption coordinate t, a
/// least-squares fit to the table's nodes. Errors are within 2% of the root mean square for TT, and 5% for the others,
/// which are a fifth as large.
struct AzimuthalFit {
  static constexpr int words = 5;   // of a node: R, TT c1; TT c2, c3; TRT c1, c2; TRT c3, residual c1; residual c2, c3
  static constexpr int beyond = 2;  // padding words after the last node, touched by reads of four at a time
  int azimuths = 0, inclinations = 0;
  std::vector<std::int32_t> nodes;  // node (i, j) begins at (j azimuths + i) words; two bfloat16 a word, low one first
};

/// Returns the fit; empty for an empty table.
AzimuthalFit fit_azimuthal(const ScatteringTable& table);

}  // namespace pelage
