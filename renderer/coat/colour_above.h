// The colour of the fur that light crosses on its way to a strand: self-shadow takes its colour from there, not from
// the strand that it falls on, or dark roots under pale tips turn black.
#pragma once

#include <array>
#include <glm/glm.hpp>

#include "protocol/commands/coat.h"
#include "renderer/coat/slices.h"

namespace pelage {

/// For the middle of each slice, by channel: the ramp's mean from there to the tip over the ramp's colour there. 1 on a
/// ramp of one colour, in [0, 100] on any; what is black there stays black.
std::array<glm::vec3, slice_count> colour_above(const Coat& coat);

}  // namespace pelage
