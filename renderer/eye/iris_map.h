// The tissue of an iris, grey, and the vessels of a sclera; made once, tinted when drawn.
#pragma once

#include <cstdint>
#include <vector>

#include "renderer/shaders/constants.h"

namespace pelage {

/// RGBA, 8 bits. Red: how much light the tissue scatters. Green: its height. Blue: how much of the inner colour it has.
/// Alpha: vessels in the sclera, rows from the limbus to the back of the eye. Deterministic.
std::vector<std::uint8_t> make_iris_map();

}  // namespace pelage
