// Pictures in memory as OpenImageIO opens and writes them.
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

/// A picture in memory whose pixels are still to be read.
struct OpenPicture {
  PictureFormat format = PictureFormat::unknown;
  std::unique_ptr<OIIO::Filesystem::IOMemReader> source;
  std::unique_ptr<OIIO::ImageInput> input;  // reads on one thread; alpha is straight where the file has it so
  OIIO::ImageSpec spec;
};

/// Goes by the first bytes. Refused (invalid) when it is of another format than `wanted`, broken, cut off, without
/// pixels, with depth, or over `max_pixels`. The bytes outlive it.
Result<OpenPicture> open_picture(std::span<const std::byte> bytes, std::span<const PictureFormat> wanted,
                                 std::size_t max_pixels);

/// Why the input gave no pixels: what OpenImageIO said, or that the picture is broken when it said nothing.
Status unreadable_pixels(const OIIO::ImageInput& input);

/// The file of these pixels, rows from the top; `type` is theirs, UNKNOWN for the specification's own.
std::string write_picture(PictureFormat format, const OIIO::ImageSpec& spec, const OIIO::TypeDesc& type,
                          const void* pixels);

}  // namespace pelage
