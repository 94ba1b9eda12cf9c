// The part of a picture that may look another way since it was drawn.
#pragma once

#include <cstdint>

#include "renderer/raster/raster_scene.h"
#include "renderer/raster/tiles.h"

namespace pelage {

/// `since` is DensityGrid::version() when the same frame was drawn last: all of the frame where that cannot be told.
/// Its curves have to be the same.
TileMask changed_since(const RasterScene& scene, std::uint64_t since, int threads);

}  // namespace pelage
