// Picture files in memory to pixels.
#pragma once

#include "renderer/picture_files/picture_files.h"

namespace pelage {

// As the members of PictureFiles.
Result<Image> decode_image(std::span<const std::byte> bytes, std::size_t max_pixels);
Result<FloatImage> decode_float_image(std::span<const std::byte> bytes, std::size_t max_pixels);
Result<DataImage> decode_data_image(std::span<const std::byte> bytes, std::size_t max_pixels, const std::string& key);
std::string text_in_picture(std::span<const std::byte> bytes, const std::string& key);

}  // namespace pelage
