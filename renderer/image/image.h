// Pictures in memory and as files: the only place that sees OpenImageIO.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "protocol/base/status.h"

namespace pelage {

/// 8-bit sRGB, straight alpha, rows from the top, 4 * width * height octets.
struct Image {
  int width = 0, height = 0;
  std::vector<std::uint8_t> rgba;
};

struct ImageText {
  std::string key, value;  // stored as PNG text
};

/// PNG with the fast settings (zlib level 1, sub filter) and sRGB marked; RGB when every alpha is 255 and
/// `keep_alpha` is false.
std::string encode_png(const Image& image, bool keep_alpha, std::span<const ImageText> texts = {});

/// PNG or JPEG from memory; refused (invalid) when it is neither, broken, or over `max_pixels`.
Result<Image> decode_image(std::span<const std::byte> octets, std::size_t max_pixels);

}  // namespace pelage
