// Pictures that were drawn in parts.
#pragma once

#include <span>
#include <string>

#include "renderer/image/image.h"

namespace pelage {

/// The file of a part, and where in the whole its pixels lie.
struct PicturePart {
  std::string bytes;
  int left = 0, top = 0;  // pixels
};

/// The file of a picture of that size whose parts, which cover it, are all PNG of 8 bits, all PNG of 16 bits, or all
/// EXR with the same channels. The bytes are those of encode_png and encode_exr for the whole. Refused (invalid) where
/// the parts are none of these, differ, are broken, or lie outside.
Result<std::string> merge_pictures(std::span<const PicturePart> parts, int width, int height, bool keep_alpha,
                                   std::span<const ImageText> texts);

}  // namespace pelage
