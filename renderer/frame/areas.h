// Maps areas between a frame's light and its finished picture, which may have different sizes.
#pragma once

#include <glm/glm.hpp>

#include "renderer/image/area.h"
#include "renderer/input/fur_scene.h"

namespace pelage {

/// Returns the pixels of a finished picture that depend on an area of its light.
Area finished_area(const Area& area, glm::ivec2 light, glm::ivec2 picture);

/// Returns the pixels of a frame's light from which its picture is made: all, or those that its crop reads.
Area drawn_area(const FurFrame& frame, glm::ivec2 light);

/// Returns the intersection of two areas; it has no pixels if they do not overlap.
Area common_area(const Area& a, const Area& b);

}  // namespace pelage
