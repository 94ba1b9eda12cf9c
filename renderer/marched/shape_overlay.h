// The bare shape of a model in place of a frame, to find places on it.
#pragma once

#include "renderer/image/float_image.h"
#include "renderer/input/fur_scene.h"
#include "renderer/marched/march_scene.h"

namespace pelage {

/// Whether an overlay is the shape of the model.
bool is_shape(Overlay overlay);

/// FurFrame::overlay, which is_shape, at the frame's size, which it hides: the skin in plain grey, lit from the camera,
/// and for Overlay::wire the edges of its triangles.
FloatImage shape_overlay(const FurFrame& frame, const MarchMesh& mesh, int threads);

}  // namespace pelage
