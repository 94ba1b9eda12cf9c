// Opens and writes pictures in memory with OpenImageIO.
#pragma once

#include <OpenImageIO/filesystem.h>
#include <OpenImageIO/imageio.h>

#include <cstddef>
#include <memory>
#include <span>
#include <string>

#include "base/status.h"

namespace pelage {

enum class PictureFormat { unknown, png, jpeg, exr, hdr };

/// A picture in memory whose pixels have not been read yet.
struct OpenPicture {
  PictureFormat format = PictureFormat::unknown;
  std::unique_ptr<OIIO::Filesystem::IOMemReader> source;
  std::unique_ptr<OIIO::ImageInput> input;  // reads on one thread; alpha is straight if it is so in the file
  OIIO::ImageSpec spec;
};

/// Opens a picture; its first bytes determine the format. Fails with invalid if the format is not in `wanted`, or the
/// picture is broken, cut off, without pixels, with depth, or over `max_pixels`. The bytes must outlive the result.
Result<OpenPicture> open_picture(std::span<const std::byte> bytes, std::span<const PictureFormat> wanted,
                                 std::size_t max_pixels);

/// Returns why the input gave no pixels: OpenImageIO's message, or that the picture is broken if there is none.
Status unreadable_pixels(const OIIO::ImageInput& input);

/// Returns the file of these pixels, rows from the top; `type` is their type, UNKNOWN for that of the specification.
std::string write_picture(PictureFormat format, const OIIO::ImageSpec& spec, const OIIO::TypeDesc& type,
                          const void* pixels);

}  // namespace pelage
