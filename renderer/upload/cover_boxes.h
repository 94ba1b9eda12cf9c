// Few boxes in place of many: what has changed on a picture, without most of what lies between.
#pragma once

#include <vector>

#include "renderer/upload/set_cells.h"

namespace pelage {

/// At most `most` (1 or more) boxes that hold all of `boxes`; more than one only where they have clearly less area
/// together, as those of a stroke across the picture. They may overlap. None for none.
std::vector<ClipBox> cover(std::vector<ClipBox> boxes, std::size_t most);

}  // namespace pelage
