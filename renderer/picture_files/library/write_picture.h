// Pixels to picture files in memory.
#pragma once

#include "renderer/picture_files/picture_files.h"

namespace pelage {

// As the members of PictureFiles.
std::string encode_jpeg(const Image& image, int quality);
std::string encode_exr(const ExrWindow& window, std::span<const ExrPlane> planes, std::span<const ImageText> texts);

}  // namespace pelage
