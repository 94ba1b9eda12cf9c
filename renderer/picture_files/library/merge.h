// Pictures that were drawn in parts.
#pragma once

#include "renderer/picture_files/picture_files.h"

namespace pelage {

/// As the member of PictureFiles.
Result<std::string> merge_pictures(std::span<const PicturePart> parts, int width, int height, bool keep_alpha,
                                   std::span<const ImageText> texts);

}  // namespace pelage
