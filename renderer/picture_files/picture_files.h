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

/// The file of a part of a picture, and the position of its pixels in the whole.
struct PicturePart {
  std::string bytes;
  int left = 0, top = 0;  // pixels
};

/// Reads and writes files as bytes in memory. Thread-safe.
class PictureFiles {
 public:
  virtual ~PictureFiles() = default;

  /// Decodes PNG or JPEG; fails with invalid for other files, broken ones, and ones over `max_pixels`.
  virtual Result<Image> decode_image(std::span<const std::byte> bytes, std::size_t max_pixels) const = 0;

  /// Decodes PNG (8 and 16 bit, taken as sRGB), JPEG, EXR or Radiance HDR. Of an EXR the first part is read: R, G, B
  /// and A, else those of the first AOV that has them ("beauty.R"), else Y as grey; alpha is 1 if there is none. NaN
  /// and infinity are kept. Fails with invalid for other files, broken ones, ones without colour, and ones over
  /// `max_pixels`.
  virtual Result<FloatImage> decode_float_image(std::span<const std::byte> bytes, std::size_t max_pixels) const = 0;

  /// Decodes the same files and .npy (decode_npy), and fails as decode_float_image and decode_npy do. The text is the
  /// one stored in the file under `key`.
  virtual Result<DataImage> decode_data_image(std::span<const std::byte> bytes, std::size_t max_pixels,
                                              const std::string& key) const = 0;

  /// Returns the text stored in a PNG or an EXR under a key; "" if there is none, or if the file cannot be read.
  virtual std::string text_in_picture(std::span<const std::byte> bytes, const std::string& key) const = 0;

  /// Encodes a JPEG for drafts, quality in [1, 100]. JPEG has no alpha and the colour is written as it is, so the
  /// picture should have been drawn over a background.
  virtual std::string encode_jpeg(const Image& image, int quality) const = 0;

  /// Encodes a lossy WebP for drafts over slow connections, quality in [1, 100]; with alpha if that is not 1
  /// everywhere.
  virtual std::string encode_webp(const Image& image, int quality) const = 0;

  /// Encodes an EXR with these channels, zip compressed (lossless); the same input gives the same bytes. Finite numbers
  /// beyond the range of half are clamped to it; NaN and infinity are kept.
  virtual std::string encode_exr(const ExrWindow& window, std::span<const ExrPlane> planes,
                                 std::span<const ImageText> texts = {}) const = 0;

  /// Merges the parts of a picture of that size into one file. The parts cover it, and are all PNG of 8 bits, all PNG
  /// of 16 bits, or all EXR with the same channels. The bytes are those that encode_png and encode_exr give for the
  /// whole. Fails with invalid if the parts are none of these, differ, are broken, or lie outside of the picture.
  virtual Result<std::string> merge_pictures(std::span<const PicturePart> parts, int width, int height, bool keep_alpha,
                                             std::span<const ImageText> texts) const = 0;

  // Colour spaces are names, aliases and roles of the OpenColorIO configuration that $OCIO names at the first use; it
  // needs the role aces_interchange. Functions fail with invalid (/colour_space) if there is no configuration or no
  // such space.

  /// Converts premultiplied interleaved RGBA from linear Rec. 709 to a colour space; pixels with an alpha of 0 are not
  /// changed.
  virtual Status to_colour_space(const std::string& space, std::span<float> rgba) const = 0;
  /// Returns the matrix from a linear colour space to linear Rec. 709; fails with invalid for spaces that are not
  /// linear too.
  virtual Result<glm::mat3> linear_from_space(const std::string& space) const = 0;

  /// Turns off the threads of the EXR library from now on, for a process that may not start any.
  virtual void read_exr_without_threads() const = 0;
};

/// Returns the implementation, which the first call loads from pelage-pictures.so next to the program: OpenImageIO
/// links some 250 libraries, which takes .3 s of CPU time, and most programs open no picture. Throws std::runtime_error
/// if that file does not exist.
const PictureFiles& picture_files();

}  // namespace pelage
