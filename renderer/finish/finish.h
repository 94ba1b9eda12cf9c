// From premultiplied linear light to the picture: size, exposure, tone map, background, sRGB, overlay.
#pragma once

#include "base/parallel.h"
#include "renderer/finish/encode.h"
#include "renderer/image/float_image.h"
#include "renderer/image/image.h"
#include "renderer/input/fur_scene.h"

namespace pelage {

/// What finishing needs beside the frame. Light of another height is enlarged or averaged to the frame's; it has its
/// aspect ratio.
struct FinishInput {
  const FloatImage& light;
  const FloatImage* overlay = nullptr;  // of the frame's size: sRGB with straight alpha; null for none
  int threads = default_threads();      // the same bits for any number
};

/// How a frame's picture is encoded, in numbers up to `largest`.
Encoding encoding_of(const FurFrame& frame, std::int32_t largest);

/// A picture of the frame's size; of one with a crop, rows outside it stay 0.
Image finish_picture(const FurFrame& frame, const FinishInput& input);
Image16 finish_picture_deep(const FurFrame& frame, const FinishInput& input);

/// The rows [top, bottom) of finish_picture, into a picture of the frame's size whose others stay.
void finish_rows(const FurFrame& frame, const FinishInput& input, int top, int bottom, Image& picture);

}  // namespace pelage
