// Small parts of a view, drawn as pictures of their own with pixels of the same size.
#pragma once

#include <glm/glm.hpp>

#include "renderer/input/fur_scene.h"

namespace pelage {

/// The frame's fur before nothing: no ground, no overlay.
FurFrame fur_alone(FurFrame frame);

/// Pixels a side of a part of a picture of that size.
int window_side(int width, int height);

/// What the frame shows about a place of its picture (pixels from the left and the top), its fur alone. The camera turns
/// towards the place, so strands are seen from their side of the view and as large as there.
FurFrame window_of(const FurFrame& frame, glm::vec2 place, int side);

}  // namespace pelage
