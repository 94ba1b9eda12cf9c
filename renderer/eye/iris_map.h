// The tissue of an iris, grey, and the vessels of a sclera; made once, tinted when drawn.
#pragma once

#include <cstdint>
#include <vector>

#include "renderer/shaders/constants.h"

namespace pelage {

inline constexpr int iris_map_width = 1024;  // around the axis; the left edge joins the right one

/// RGBA, 8 bits. Red: how much light the tissue scatters. Green: its height. Blue: how much of the inner colour it has.
/// Alpha: vessels in the sclera, rows from the limbus to the back of the eye. Deterministic.
std::vector<std::uint8_t> make_iris_map();

}  // namespace pelage
