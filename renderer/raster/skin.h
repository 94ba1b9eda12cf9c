// The skin that strands stand on: which triangle is nearest in each pixel of a box, and its light.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "renderer/raster/bins.h"
#include "renderer/raster/raster_scene.h"

namespace pelage {

/// What lies behind the strands of a box; pixels by tile, in a tile as pixel_in_tile has them.
struct SkinPixels {
  std::vector<float> inverse;        // one over the distance, 0 for nothing
  std::vector<std::uint32_t> piece;  // triangle of the model
  std::vector<float> furthest;       // of each tile, one over the distance: 0 where any pixel of it is empty
  std::vector<float> hidden;         // the same of blocks of hiding_side pixels, row by row of the box

  /// Of the scene's model.
  SkinPixels(const RasterScene& scene, const RasterBox& box, int threads);
};

}  // namespace pelage
