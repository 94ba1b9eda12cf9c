// A second implementation of every tool, written from docs/, science.md 3 and openapi.yaml as plain loops over all
// vertices. It includes nothing of the folder that it checks.
#pragma once

#include "tests/property/groom/reference/body.h"

namespace pelage::plain {

/// The fur after a resolved tool, in double, held in the ranges of its fields.
/// Interpolate and flow take the distances `straight` and `dijkstra`; `heat` is compared to exact distances instead.
Fur groomed(const Command& command, const Stage& stage, const Fur& before);

/// The command and all its images under the symmetry, for commands whose strokes name positions.
std::vector<Command> images(const Command& command, const Symmetry& symmetry);

}  // namespace pelage::plain
