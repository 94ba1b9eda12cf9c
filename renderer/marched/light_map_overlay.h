// Maps of a light in place of a frame, for inspection.
#pragma once

#include <optional>

#include "renderer/image/float_image.h"
#include "renderer/input/fur_scene.h"
#include "renderer/marched/march_scene.h"

namespace pelage {

/// Whether an overlay is a map of a light and not a picture of the model.
bool is_light_map(Overlay overlay);

/// FurFrame::overlay, which is_light_map, of the first light that casts a shadow, as the light sees the model: greys in
/// the largest square of the frame, which they hide. None where no light of the frame has such a map.
std::optional<FloatImage> light_map_overlay(const FurFrame& frame, const MarchMesh& mesh, int threads);

}  // namespace pelage
