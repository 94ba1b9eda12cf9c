// PNG of pictures that follow one another: rows that have not changed are not compressed again.
#pragma once

#include <deque>
#include <memory>
#include <mutex>
#include <string>
#include <vector>

#include "renderer/image/png_bands.h"

namespace pelage {

/// Thread-safe. Keeps the last pictures and what they were compressed to, and compares: the bytes are those that
/// encode_png gives.
class PngEncoder {
 public:
  /// What is kept has at most so many pixels.
  explicit PngEncoder(std::size_t most_pixels = std::size_t{2048} * 2048) : most_pixels_(most_pixels) {}

  /// As encode_png.
  std::string encode(Image image, bool keep_alpha);

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

  const std::size_t most_pixels_;
  mutable std::mutex mutex_;
  Pictures pictures_;
};

}  // namespace pelage
