// A reference implementation of every tool, written from docs/, science.md 3 and openapi.yaml as plain loops over all
// vertices. It includes nothing of the folder that it checks.
#pragma once

#include "tests/property/groom/reference/body.h"

namespace pelage::plain {

/// Returns the fur after a resolved tool, in double, clamped to the ranges of its fields. Of the distances of
/// interpolate and flow it knows `straight` and `dijkstra`; `heat` is compared with exact distances instead.
Fur groomed(const Command& command, const Stage& stage, const Fur& before);

/// Returns the command and all its images under the symmetry. The command's strokes must name positions.
std::vector<Command> images(const Command& command, const Symmetry& symmetry);

}  // namespace pelage::plain
