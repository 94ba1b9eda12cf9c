// Turns premultiplied linear light into the final picture: size, exposure, tone mapping, background, sRGB, overlay.
#pragma once

#include "base/parallel.h"
#include "renderer/finish/encode.h"
#include "renderer/image/float_image.h"
#include "renderer/image/image.h"
#include "renderer/input/fur_scene.h"

namespace pelage {

/// The inputs besides the frame. Light of another height is enlarged or averaged to the frame's size; its aspect ratio
/// must be the frame's.
struct FinishInput {
  const FloatImage& light;
  const FloatImage* overlay = nullptr;  // sRGB with straight alpha, of the frame's size; null for none
  int threads = default_threads();      // does not change the result
};

/// Returns the encoding of a frame's picture, in numbers up to `largest`.
Encoding encoding_of(const FurFrame& frame, std::int32_t largest);

/// Returns a picture of the frame's size; with a crop, rows outside of it stay 0.
Image finish_picture(const FurFrame& frame, const FinishInput& input);
Image16 finish_picture_deep(const FurFrame& frame, const FinishInput& input);

/// Writes the rows [top, bottom) of finish_picture into a picture of the frame's size, and leaves the others.
void finish_rows(const FurFrame& frame, const FinishInput& input, int top, int bottom, Image& picture);

}  // namespace pelage
