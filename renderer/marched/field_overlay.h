// Fields on the skin as colours over a frame, for inspection.
#pragma once

#include "renderer/image/float_image.h"
#include "renderer/input/fur_scene.h"
#include "renderer/marched/march_scene.h"

namespace pelage {

/// FurFrame::overlay, which is_field, at the frame's size: sRGB with straight alpha. Fields lie on the skin: where only
/// tips reach, the frame shows as it is.
FloatImage field_overlay(const FurFrame& frame, const MarchMesh& mesh, int threads);

}  // namespace pelage
