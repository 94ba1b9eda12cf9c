// A grey map of an iris's tissue and of the vessels of a sclera; made once and tinted when drawn.
#pragma once

#include <cstdint>
#include <vector>

#include "renderer/shaders/constants.h"

namespace pelage {

/// Returns an RGBA map of 8 bits. Red: scattering of the tissue. Green: its height. Blue: share of the inner colour.
/// Alpha: vessels in the sclera, in rows from the limbus to the back of the eye. Deterministic.
std::vector<std::uint8_t> make_iris_map();

}  // namespace pelage
