// PNG files (ISO/IEC 15948) out of bands of rows that are compressed one by one. As a band says nothing of the rows
// around it, equal rows give equal bytes, and a file can be put together from bands of a file before it.
#pragma once

#include <cstdint>
#include <deque>
#include <memory>
#include <mutex>
#include <span>
#include <string>
#include <vector>

#include "renderer/image/image.h"

namespace pelage {

struct PngLayout {
  int width = 0, height = 0;
  int channels = 4;  // 3: RGB, 4: RGBA
  int bits = 8;      // of a sample: 8 or 16

  bool operator==(const PngLayout&) const = default;
};

/// That of a picture: without alpha where it is 1 everywhere and need not be kept.
PngLayout png_layout(const Image& image, bool keep_alpha);
PngLayout png_layout(const Image16& image, bool keep_alpha);

/// Bands of 16 rows, the last one with what is left: so short that a stroke changes few, so long that what each costs
/// by itself (some 30 bytes) does not show.
std::uint32_t png_band_count(const PngLayout& layout);

/// The samples of a band, from the top; RGBA, also where the layout leaves out alpha.
std::span<const std::uint8_t> png_band_of(const Image& image, std::uint32_t band);
std::span<const std::uint16_t> png_band_of(const Image16& image, std::uint32_t band);

struct PngBand {
  std::string chunk;        // IDAT, with its length and checksum
  std::uint32_t adler = 1;  // of the filtered rows
  std::size_t bytes = 0;    // of the filtered rows
};

/// Compressed by sub filter and run lengths: matches of the noise of fur take a fifth longer and are larger.
PngBand png_band(const PngLayout& layout, std::span<const std::uint8_t> rgba);
PngBand png_band(const PngLayout& layout, std::span<const std::uint16_t> rgba);

/// The file of all bands of a layout.
std::string png_file(const PngLayout& layout, std::span<const std::shared_ptr<const PngBand>> bands,
                     std::span<const ImageText> texts, PngNumbers numbers);

// PNG of pictures that follow one another: rows that have not changed are not compressed again.

/// Thread-safe. Keeps the last pictures and what they were compressed to, and compares: the bytes are those that
/// encode_png gives.
class PngEncoder {
 public:
  /// Compresses on up to so many threads. What is kept has at most so many pixels.
  explicit PngEncoder(int threads, std::size_t max_pixels = std::size_t{2048} * 2048)
      : threads_(threads), max_pixels_(max_pixels) {}

  /// As encode_png.
  std::string encode(Image image, bool keep_alpha, std::span<const ImageText> texts = {});
  /// The same of a picture that is not kept.
  std::string encode(const Image16& image, bool keep_alpha, std::span<const ImageText> texts = {}) const {
    return encode_png(image, keep_alpha, texts, PngNumbers::srgb, threads_);
  }

 private:
  /// A picture and its bands. Never changes, so several may read it.
  struct Kept {
    Image image;
    PngLayout layout;
    std::vector<std::shared_ptr<const PngBand>> bands;
  };
  using Pictures = std::deque<std::shared_ptr<const Kept>>;  // the newest first

  Pictures pictures_of(const PngLayout& layout) const;
  /// `picture` takes the place of `source`, or of the oldest where there is none and no room.
  void keep(std::shared_ptr<const Kept> picture, const Kept* source);

  /// The first of some pictures that has these rows there; null for none.
  static const Kept* same_band(const Pictures& before, std::span<const std::uint8_t> rows, std::uint32_t band);

  const int threads_;
  const std::size_t max_pixels_;
  mutable std::mutex mutex_;
  Pictures pictures_;
};

}  // namespace pelage
