// Finds the tiles of a picture that may look different from when the same view was last drawn.
#pragma once

#include <cstdint>

#include "renderer/raster/raster_scene.h"
#include "renderer/raster/tiles.h"

namespace pelage {

/// Returns the tiles that may have changed since DensityGrid::version() was `since`, when the same frame was last
/// drawn; all tiles if anything may have changed, as when the lights or the near cells have. The frame's curves must be
/// the same.
TileMask changed_since(const RasterScene& scene, std::uint64_t since, int threads);

}  // namespace pelage
