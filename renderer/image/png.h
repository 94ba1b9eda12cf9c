// PNG files (ISO/IEC 15948) from bands of rows that are compressed independently. Because a band does not depend on the
// rows around it, equal rows give equal bytes, and a file can reuse bands of an earlier file.
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

/// Returns the layout of a picture: without alpha if that is 1 everywhere and `keep_alpha` is false.
PngLayout png_layout(const Image& image, bool keep_alpha);
PngLayout png_layout(const Image16& image, bool keep_alpha);

/// Returns the number of bands of 16 rows; the last one may be shorter. Bands are so short that a stroke changes few of
/// them, and so long that their overhead (some 30 bytes each) is negligible.
std::uint32_t png_band_count(const PngLayout& layout);

/// Returns the samples of a band, counted from the top; RGBA, even if the layout has no alpha.
std::span<const std::uint8_t> png_band_of(const Image& image, std::uint32_t band);
std::span<const std::uint16_t> png_band_of(const Image16& image, std::uint32_t band);

struct PngBand {
  std::string chunk;        // IDAT chunk with its length and checksum
  std::uint32_t adler = 1;  // of the filtered rows
  std::size_t bytes = 0;    // of the filtered rows
};

/// Compresses a band with the sub filter and run lengths: matching the noise of fur takes a fifth longer and gives
/// larger files.
PngBand png_band(const PngLayout& layout, std::span<const std::uint8_t> rgba);
PngBand png_band(const PngLayout& layout, std::span<const std::uint16_t> rgba);

/// Returns the file made of all bands of a layout.
std::string png_file(const PngLayout& layout, std::span<const std::shared_ptr<const PngBand>> bands,
                     std::span<const ImageText> texts, PngNumbers numbers);

// PNG encoding of successive pictures: rows that have not changed are not compressed again.

/// Caches the last pictures with their compressed bands, and compares new pictures to them. The bytes are those that
/// encode_png gives. Thread-safe.
class PngEncoder {
 public:
  /// Compresses on up to `threads` threads. The cached pictures have at most `max_pixels` in all.
  explicit PngEncoder(int threads, std::size_t max_pixels = std::size_t{2048} * 2048)
      : threads_(threads), max_pixels_(max_pixels) {}

  /// Encodes like encode_png.
  std::string encode(Image image, bool keep_alpha, std::span<const ImageText> texts = {});
  /// The same, but the picture is not cached.
  std::string encode(const Image16& image, bool keep_alpha, std::span<const ImageText> texts = {}) const {
    return encode_png(image, keep_alpha, texts, PngNumbers::srgb, threads_);
  }

 private:
  /// A picture and its bands. Immutable, so several threads may read it.
  struct CachedPicture {
    Image image;
    PngLayout layout;
    std::vector<std::shared_ptr<const PngBand>> bands;
  };
  using Pictures = std::deque<std::shared_ptr<const CachedPicture>>;  // newest first

  Pictures pictures_of(const PngLayout& layout) const;
  /// Caches `picture` in place of `source`, or of the oldest ones if `source` is null and there is no room.
  void cache(std::shared_ptr<const CachedPicture> picture, const CachedPicture* source);

  /// Returns the first of some pictures that has the same rows in a band; null for none.
  static const CachedPicture* same_band(const Pictures& before, std::span<const std::uint8_t> rows, std::uint32_t band);

  const int threads_;
  const std::size_t max_pixels_;
  mutable std::mutex mutex_;
  Pictures pictures_;
};

}  // namespace pelage
