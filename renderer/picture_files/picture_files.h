// Reading and writing picture files through OpenImageIO.
#pragma once

#include <cstddef>
#include <glm/glm.hpp>
#include <span>
#include <string>

#include "base/status.h"
#include "renderer/image/float_image.h"
#include "renderer/image/image.h"

namespace pelage {

/// The file of a part of a picture, and where in the whole its pixels lie.
struct PicturePart {
  std::string bytes;
  int left = 0, top = 0;  // pixels
};

/// Thread-safe. Files are bytes in memory.
class PictureFiles {
 public:
  virtual ~PictureFiles() = default;

  /// PNG or JPEG; refused (invalid) when it is neither, broken, or over `max_pixels`.
  virtual Result<Image> decode_image(std::span<const std::byte> bytes, std::size_t max_pixels) const = 0;

  /// PNG (8 and 16 bit, taken as sRGB), JPEG, EXR or Radiance HDR. Of an EXR the first part is read: R, G, B and A,
  /// else those of the first shell that has them ("beauty.R"), else Y as grey; alpha is 1 where there is none. NaN and
  /// infinity stay. Refused (invalid) when it is none of these, broken, without colour, or over `max_pixels`.
  virtual Result<FloatImage> decode_float_image(std::span<const std::byte> bytes, std::size_t max_pixels) const = 0;

  /// The same files and .npy (decode_npy), refused as decode_float_image and decode_npy do. The text is what the file
  /// keeps under `key`.
  virtual Result<DataImage> decode_data_image(std::span<const std::byte> bytes, std::size_t max_pixels,
                                              const std::string& key) const = 0;

  /// What the file of a PNG or an EXR keeps under a key; "" for nothing, and for what cannot be read.
  virtual std::string text_in_picture(std::span<const std::byte> bytes, const std::string& key) const = 0;

  /// JPEG for drafts, quality in [1, 100]. JPEG has no alpha: the colour is written as it is, so draw over a
  /// background.
  virtual std::string encode_jpeg(const Image& image, int quality) const = 0;

  /// Lossy WebP for drafts over slow lines, quality in [1, 100]; with its alpha where that is not 1 everywhere.
  virtual std::string encode_webp(const Image& image, int quality) const = 0;

  /// An EXR with these channels, zip compressed (lossless); the same input gives the same bytes. Finite numbers beyond
  /// the range of half are held at its largest; NaN and infinity stay.
  virtual std::string encode_exr(const ExrWindow& window, std::span<const ExrPlane> planes,
                                 std::span<const ImageText> texts = {}) const = 0;

  /// The file of a picture of that size whose parts, which cover it, are all PNG of 8 bits, all PNG of 16 bits, or all
  /// EXR with the same channels. The bytes are those of encode_png and encode_exr for the whole. Refused (invalid)
  /// where the parts are none of these, differ, are broken, or lie outside.
  virtual Result<std::string> merge_pictures(std::span<const PicturePart> parts, int width, int height, bool keep_alpha,
                                             std::span<const ImageText> texts) const = 0;

  // Colour spaces are names, aliases and roles of the OpenColorIO configuration that $OCIO names when the first is
  // asked for; it needs the role aces_interchange. Refused (invalid, /colour_space) where there is none, or no such
  // space.

  /// Converts light, interleaved RGBA multiplied by alpha, from linear Rec. 709 to a colour space; what has an alpha of
  /// 0 stays.
  virtual Status to_colour_space(const std::string& space, std::span<float> rgba) const = 0;
  /// What takes light of a linear colour space to linear Rec. 709; refused for spaces that are not linear too.
  virtual Result<glm::mat3> linear_from_space(const std::string& space) const = 0;

  /// Makes the library of EXR do without threads from here on, for a process that may start none.
  virtual void read_exr_without_threads() const = 0;
};

/// Loaded from pelage-pictures.so beside the program at the first call: OpenImageIO links some 250 libraries, .3 s of
/// computing for programs that most often open no picture. Throws std::runtime_error where that file is not there.
const PictureFiles& picture_files();

}  // namespace pelage
