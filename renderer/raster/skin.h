// Rasterizes the skin and the eyes behind the strands: which triangle or eye is nearest in each pixel of a box.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "renderer/raster/bins.h"
#include "renderer/raster/raster_scene.h"

namespace pelage {

/// What lies behind the strands of a box. Pixels lie tile by tile, within a tile in the order of pixel_in_tile.
struct SkinPixels {
  std::vector<float> inverse;           // 1 / distance of the skin, 0 for none
  std::vector<std::uint32_t> triangle;  // triangle of the model
  std::vector<std::int8_t> eyes;        // number of the eye in front of the skin, -1 for none; empty without eyes
  std::vector<float> furthest;          // for each tile, 1 / its furthest distance: 0 if any pixel of it is empty
  std::vector<float> hidden;  // for each block of hiding_side pixels, row by row: 1 / the furthest distance within
                              // hiding_radius pixels of it; 0 if those reach out of the box

  /// Rasterizes the scene's model and eyes.
  SkinPixels(const RasterScene& scene, const PixelBox& box, int threads);

  /// Returns 1 / distance of the eye or the skin behind the strands in each pixel, 0 for none.
  const std::vector<float>& background_inverse() const { return eyes.empty() ? inverse : with_eyes_; }

 private:
  /// Adds the eyes of a tile. Returns the tile's part of background_inverse().
  float* add_eyes(const RasterScene& scene, std::uint32_t tile, int left, int top);

  /// Makes each block's number in `hidden` the furthest around it; `across` and `down` count blocks.
  void dilate_hidden(int across, int down);

  std::vector<float> with_eyes_;
};

}  // namespace pelage
