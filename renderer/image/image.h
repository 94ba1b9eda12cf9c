// What the readers and writers of pictures share: the kind of a file by its first bytes, and clear refusals.
#pragma once

#include <OpenImageIO/filesystem.h>
#include <OpenImageIO/imageio.h>

#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "protocol/base/status.h"

namespace pelage {

enum class PictureFormat { unknown, png, jpeg, exr, hdr };

PictureFormat format_of(std::string_view bytes);

/// The file's name as OpenImageIO wants it to choose a reader or a writer. Not for `unknown`.
const char* name_of(PictureFormat format);

/// Whether a PNG ends before its IEND or a JPEG before its end marker; the readers of EXR and HDR notice by themselves.
bool is_cut_off(PictureFormat format, std::string_view bytes);

/// An `invalid` Status: "The picture cannot be read: REASON".
inline constexpr std::string_view unreadable_picture = "The picture cannot be read: ";
Status unreadable(const std::string& reason);

/// What OpenImageIO said, or that the picture is broken when it said nothing.
std::string reason_of(const std::string& text);

/// Refuses pictures without pixels, with depth, or with more than `max_pixels`.
Status check_size(const OIIO::ImageSpec& spec, std::size_t max_pixels);

/// A picture in memory whose pixels are still to be read.
struct OpenPicture {
  PictureFormat format = PictureFormat::unknown;
  std::unique_ptr<OIIO::Filesystem::IOMemReader> source;
  std::unique_ptr<OIIO::ImageInput> input;  // reads on one thread; alpha is straight where the file has it so
  OIIO::ImageSpec spec;
};

/// Refused (invalid) when it is of another format than `wanted`, broken, or over `max_pixels`. The bytes outlive it.
Result<OpenPicture> open_picture(std::span<const std::byte> bytes, std::span<const PictureFormat> wanted,
                                 std::size_t max_pixels);

/// What the file of a PNG or an EXR keeps under a key; "" for nothing, and for what cannot be read.
std::string text_in_picture(std::span<const std::byte> bytes, const std::string& key);

/// The file of these pixels, rows from the top; `type` is theirs, UNKNOWN for the specification's own.
std::string write_picture(PictureFormat format, const OIIO::ImageSpec& spec, const OIIO::TypeDesc& type,
                          const void* pixels);

// 8-bit and 16-bit pictures in memory and as files. Only this folder sees OpenImageIO.

/// 8-bit sRGB, straight alpha, rows from the top, 4 * width * height bytes.
struct Image {
  int width = 0, height = 0;
  std::vector<std::uint8_t> rgba;
};

/// The same with 16 bits.
struct Image16 {
  int width = 0, height = 0;
  std::vector<std::uint16_t> rgba;
};

struct ImageText {
  std::string key, value;  // stored as PNG text or as an attribute of an EXR
};

/// Whether a PNG's numbers are colours, marked as sRGB, or data without a mark.
enum class PngNumbers { srgb, data };

/// PNG with the fast settings (zlib level 1, sub filter); RGB when every alpha is at its largest and
/// `keep_alpha` is false.
std::string encode_png(const Image& image, bool keep_alpha, std::span<const ImageText> texts = {},
                       PngNumbers numbers = PngNumbers::srgb);
std::string encode_png(const Image16& image, bool keep_alpha, std::span<const ImageText> texts = {},
                       PngNumbers numbers = PngNumbers::srgb);

/// JPEG for drafts, quality in [1, 100]. JPEG has no alpha: the colour is written as it is, so draw over a background.
std::string encode_jpeg(const Image& image, int quality);

/// PNG or JPEG from memory; refused (invalid) when it is neither, broken, or over `max_pixels`.
Result<Image> decode_image(std::span<const std::byte> bytes, std::size_t max_pixels);

}  // namespace pelage
