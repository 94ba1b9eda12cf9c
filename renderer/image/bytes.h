// What the readers and writers of pictures share: the kind of a file by its first bytes, and clear refusals.
#pragma once

#include <OpenImageIO/imageio.h>

#include <cstddef>
#include <string>
#include <string_view>

#include "protocol/base/status.h"

namespace pelage {

enum class PictureFormat { unknown, png, jpeg, exr, hdr };

PictureFormat format_of(std::string_view bytes);

/// The file's name as OpenImageIO wants it to choose a reader or a writer. Not for `unknown`.
const char* name_of(PictureFormat format);

/// Whether a PNG ends before its IEND or a JPEG before its end marker; the readers of EXR and HDR notice by themselves.
bool is_cut_off(PictureFormat format, std::string_view bytes);

/// An `invalid` Status: "The picture cannot be read: REASON".
Status unreadable(const std::string& reason);

/// What OpenImageIO said, or that the picture is broken when it said nothing.
std::string reason_of(const std::string& text);

/// Refuses pictures without pixels, with depth, or with more than `max_pixels`.
Status check_size(const OIIO::ImageSpec& spec, std::size_t max_pixels);

/// The file of these pixels, rows from the top; `type` is theirs, UNKNOWN for the specification's own.
std::string write_picture(PictureFormat format, const OIIO::ImageSpec& spec, OIIO::TypeDesc type, const void* pixels);

}  // namespace pelage
