// From premultiplied linear light to the picture without a GL: size, exposure, tone map, background, sRGB. The twin of
// renderer/passes/resolve/resolve.frag.
#pragma once

#include "protocol/base/parallel.h"
#include "renderer/image/float_image.h"
#include "renderer/image/image.h"
#include "renderer/input/fur_scene.h"

namespace pelage {

/// A picture of the frame's size. Light of another height is enlarged or averaged to it; it has the frame's aspect
/// ratio. The frame's overlay is left out. The same bits for any number of threads.
Image finish_picture(const FurFrame& frame, const FloatImage& light, int threads = default_threads());
Image16 finish_picture_deep(const FurFrame& frame, const FloatImage& light, int threads = default_threads());

/// The rows [top, bottom) of finish_picture, into a picture of the frame's size whose others stay.
void finish_rows(const FurFrame& frame, const FloatImage& light, int top, int bottom, Image& picture,
                 int threads = default_threads());

}  // namespace pelage
