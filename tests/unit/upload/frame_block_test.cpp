#include <gtest/gtest.h>

#include <cmath>

#include "renderer/upload/blocks.h"

namespace pelage {
namespace {

float finest_texel(int drawn) {
  FurFrame frame;
  frame.width = frame.height = 100;
  return make_frame_block(frame, Slices{}, false, drawn).tile.y;
}

// Enlarging blurs, and texels as large as the drawn pixels would be blurred twice.
TEST(FrameBlock, PartSizePicturesReadFinerTexels) {
  EXPECT_NEAR(finest_texel(25) / finest_texel(100), 2, 1e-6);
  EXPECT_NEAR(finest_texel(60) / finest_texel(100), std::sqrt(1 / 0.6), 1e-6);
}

TEST(FrameBlock, LargerPicturesReadTheTexelsOfTheirPixels) { EXPECT_EQ(finest_texel(200), finest_texel(100)); }

}  // namespace
}  // namespace pelage
