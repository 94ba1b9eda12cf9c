// 8-bit and 16-bit pictures in memory, and their PNG encoding.
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "base/parallel.h"
#include "base/status.h"

namespace pelage {

/// 8-bit sRGB, straight alpha, rows from the top, 4 * width * height bytes.
struct Image {
  int width = 0, height = 0;
  std::vector<std::uint8_t> rgba;
};

/// 16-bit sRGB, straight alpha, rows from the top, 4 * width * height numbers.
struct Image16 {
  int width = 0, height = 0;
  std::vector<std::uint16_t> rgba;
};

struct ImageText {
  std::string key, value;  // stored as PNG text or as an attribute of an EXR
};

/// The meaning of a PNG's numbers: colours, marked as sRGB, or data, which are not marked.
enum class PngNumbers { srgb, data };

/// Encodes a PNG with fast settings (zlib level 1, sub filter); as RGB if all alpha is at its largest value and
/// `keep_alpha` is false. The same bytes for any number of threads.
std::string encode_png(const Image& image, bool keep_alpha, std::span<const ImageText> texts = {},
                       PngNumbers numbers = PngNumbers::srgb, int threads = default_threads());
std::string encode_png(const Image16& image, bool keep_alpha, std::span<const ImageText> texts = {},
                       PngNumbers numbers = PngNumbers::srgb, int threads = default_threads());

/// Returns an `invalid` Status: "The picture cannot be read: REASON".
inline constexpr std::string_view unreadable_picture = "The picture cannot be read: ";
Status unreadable(const std::string& reason);

/// Returns a picture of zeros: Image, Image16 or FloatImage.
template <class Picture>
Picture empty_picture(int width, int height) {
  Picture picture;
  picture.width = width, picture.height = height;
  picture.rgba.resize(4 * static_cast<std::size_t>(width) * static_cast<std::size_t>(height));
  return picture;
}

}  // namespace pelage
