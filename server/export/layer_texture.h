// The slices of a coat's tile, several at a time, as textures for other programs.
#pragma once

#include <vector>

#include "renderer/coat/slices.h"
#include "renderer/image/image.h"

namespace pelage {

/// The slices that one layer of a number of them stands for.
struct SliceBin {
  int first = 0, last = 0;  // half open
  double height = 0;        // s of its middle, (0, 1)
};
SliceBin bin_of(int layer, int layers);

/// Where strands stand in one layer, and how light they are.
class LayerTexture {
 public:
  static constexpr float headroom = 1.6f;  // strands may be lighter than their mean by so much

  LayerTexture(const SliceLevel& level, const SliceBin& bin);

  /// sRGB: lightness over the layer's mean and over the headroom, in grey. Alpha: opacity.
  Image image() const;

 private:
  int texels_;
  std::vector<float> opacity_, lightness_;
};

}  // namespace pelage
