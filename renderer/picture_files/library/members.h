// Functions that implement the members of PictureFiles.
#pragma once

#include "renderer/picture_files/picture_files.h"

namespace pelage {

Result<Image> decode_image(std::span<const std::byte> bytes, std::size_t max_pixels);
Result<FloatImage> decode_float_image(std::span<const std::byte> bytes, std::size_t max_pixels);
Result<DataImage> decode_data_image(std::span<const std::byte> bytes, std::size_t max_pixels, const std::string& key);
std::string text_in_picture(std::span<const std::byte> bytes, const std::string& key);

std::string encode_jpeg(const Image& image, int quality);
std::string encode_webp(const Image& image, int quality);
std::string encode_exr(const ExrWindow& window, std::span<const ExrPlane> planes, std::span<const ImageText> texts);

Result<std::string> merge_pictures(std::span<const PicturePart> parts, int width, int height, bool keep_alpha,
                                   std::span<const ImageText> texts);

Status to_colour_space(const std::string& space, std::span<float> rgba);
Result<glm::mat3> linear_from_space(const std::string& space);

}  // namespace pelage
