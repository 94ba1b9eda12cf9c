// Merges the slices of a coat's tile into fewer shell textures for other programs.
#pragma once

#include <vector>

#include "renderer/coat/slices.h"
#include "renderer/image/image.h"

namespace pelage {

/// The slices that one exported shell combines.
struct SliceBin {
  int first = 0, last = 0;  // [first, last)
  double height = 0;        // s of its middle, (0, 1)
};
SliceBin bin_of(int shell, int shell_count);

/// The texture of one exported shell: opacity and lightness of its strands.
class ShellTexture {
 public:
  static constexpr float headroom = 1.6f;  // maximum lightness of strands, relative to their mean

  ShellTexture(const SliceLevel& level, const SliceBin& bin);

  /// Returns the texture. sRGB: lightness divided by the shell's mean and by the headroom, in grey. Alpha: opacity.
  Image image() const;

 private:
  int texels_;
  std::vector<float> opacity_, lightness_;
};

}  // namespace pelage
