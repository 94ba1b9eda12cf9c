#include "renderer/image/image.h"

#include <memory>

#include "renderer/image/png.h"

namespace pelage {

Status unreadable(const std::string& reason) {
  return failure(Code::invalid, std::string(unreadable_picture) + reason);
}

namespace {

template <class Picture>
std::string encode_png_of(const Picture& image, bool keep_alpha, std::span<const ImageText> texts, PngNumbers numbers,
                          int threads) {
  const PngLayout layout = png_layout(image, keep_alpha);
  std::vector<std::shared_ptr<const PngBand>> bands(png_band_count(layout));
  const auto compress = [&](std::uint32_t band) {
    bands[band] = std::make_shared<const PngBand>(png_band(layout, png_band_of(image, band)));
  };
  for_each_in_parallel(png_band_count(layout), compress, threads);
  return png_file(layout, bands, texts, numbers);
}

}  // namespace

std::string encode_png(const Image& image, bool keep_alpha, std::span<const ImageText> texts, PngNumbers numbers,
                       int threads) {
  return encode_png_of(image, keep_alpha, texts, numbers, threads);
}

std::string encode_png(const Image16& image, bool keep_alpha, std::span<const ImageText> texts, PngNumbers numbers,
                       int threads) {
  return encode_png_of(image, keep_alpha, texts, numbers, threads);
}

}  // namespace pelage
