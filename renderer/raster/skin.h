// The skin that strands stand on, and eyes in it: which triangle or eye is nearest in each pixel of a box.
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
  std::vector<std::int8_t> eyes;     // number of the eye before it, -1 for none; empty without eyes
  std::vector<float> furthest;       // of each tile, one over the distance: 0 where any pixel of it is empty
  std::vector<float> hidden;         // the same of all within hidden_around of each block of hiding_side pixels, row by
                                     // row; 0 where that reaches out of the box

  /// Of the scene's model.
  SkinPixels(const RasterScene& scene, const PixelBox& box, int threads);

  /// One over the distance of what ends the view of strands: an eye, the skin or nothing.
  const std::vector<float>& ends() const { return eyes.empty() ? inverse : with_eyes_; }

 private:
  /// Gives what ends strands there.
  float* add_eyes(const RasterScene& scene, std::uint32_t tile, int left, int top);

  void spread_hidden(int across, int down);

  std::vector<float> with_eyes_;
};

}  // namespace pelage
