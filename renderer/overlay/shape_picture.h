// The bare shape of a model in place of a frame, to find places on it.
#pragma once

#include "renderer/image/float_image.h"
#include "renderer/input/fur_scene.h"

namespace pelage {

/// Overlay::bald or wire at the frame's size, which it hides: the skin in plain grey, lit from the camera, and for wire
/// the edges of its triangles. Of each pixel, row by row, `normals` has the normal of the skin that is seen and 1, 0
/// where there is none; the first number of `pieces` that of its piece of the model.
FloatImage shape_picture(const FurFrame& frame, const FurModel& model, const FloatImage& normals,
                         const FloatImage& pieces, int threads);

}  // namespace pelage
