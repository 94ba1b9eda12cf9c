// Fields on the skin as colours over a frame, for inspection.
#pragma once

#include "renderer/image/float_image.h"
#include "renderer/input/fur_scene.h"
#include "renderer/marched/march_scene.h"

namespace pelage {

/// Whether an overlay is a picture of the skin: a field, strokes along the fur or the difference.
bool is_field(Overlay overlay);

/// FurFrame::overlay, which is_field, at the frame's size: sRGB with straight alpha. Fields lie on the skin: where only
/// tips reach, the frame shows as it is.
FloatImage field_overlay(const FurFrame& frame, const MarchMesh& mesh, int threads);

/// How often fur was shaded at each pixel (Aov::shell_count), from nothing to twice the shells, as field_overlay
/// colours a length.
FloatImage count_overlay(const FloatImage& counts, int shells);

}  // namespace pelage
