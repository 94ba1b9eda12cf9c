// Which pixels of a frame's light, which has a size of its own, belong to which of its picture.
#pragma once

#include <glm/glm.hpp>

#include "renderer/image/area.h"
#include "renderer/input/fur_scene.h"

namespace pelage {

/// The pixels of a finished picture that an area of its light touches.
Area finished_area(const Area& area, glm::ivec2 light, glm::ivec2 picture);

/// The pixels of a frame's light that its picture is made of: all, or those that its crop reads.
Area drawn_area(const FurFrame& frame, glm::ivec2 light);

/// The intersection of two areas; it has no pixels if they do not overlap.
Area common_area(const Area& a, const Area& b);

}  // namespace pelage
