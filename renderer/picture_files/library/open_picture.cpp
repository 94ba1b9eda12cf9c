#include "renderer/picture_files/library/open_picture.h"

#include <algorithm>
#include <array>
#include <cassert>
#include <string_view>
#include <vector>

#include "renderer/image/image.h"

namespace pelage {

namespace {

using namespace std::string_view_literals;

/// Returns true if the chunks of a PNG end before IEND.
bool is_png_cut_off(std::string_view bytes) {
  constexpr std::size_t signature = 8, frame = 12;  // bytes of a chunk's length, name and checksum
  bytes.remove_prefix(signature);
  while (bytes.size() >= frame) {
    std::size_t length = 0;
    for (std::size_t i = 0; i < 4; ++i) length = length << 8 | static_cast<unsigned char>(bytes[i]);
    if (length > bytes.size() - frame) return true;
    if (bytes.substr(4, 4) == "IEND") return false;
    bytes.remove_prefix(frame + length);
  }
  return true;
}

/// Returns true if a JPEG has no end marker after its last scan: libjpeg would fill the missing part with grey and
/// succeed.
bool is_jpeg_cut_off(std::string_view bytes) {
  const std::size_t scan = bytes.rfind("\xff\xda"), end = bytes.rfind("\xff\xd9");
  return scan == std::string_view::npos || end == std::string_view::npos || end < scan;
}

/// Returns a list such as "PNG, JPEG nor EXR".
std::string list_of(std::span<const PictureFormat> formats) {
  constexpr std::array names{"unknown", "PNG", "JPEG", "EXR", "HDR"};
  std::string list;
  for (std::size_t i = 0; i < formats.size(); ++i) {
    if (i > 0) list += i + 1 < formats.size() ? ", " : " nor ";
    list += names.at(static_cast<std::size_t>(formats[i]));
  }
  return list;
}

PictureFormat format_of(std::string_view bytes) {
  if (bytes.starts_with("\x89PNG\r\n\x1a\n"sv)) return PictureFormat::png;
  if (bytes.starts_with("\xff\xd8\xff"sv)) return PictureFormat::jpeg;
  if (bytes.starts_with("\x76\x2f\x31\x01"sv)) return PictureFormat::exr;
  if (bytes.starts_with("#?RADIANCE"sv) || bytes.starts_with("#?RGBE"sv)) return PictureFormat::hdr;
  return PictureFormat::unknown;
}

const char* name_of(PictureFormat format) {
  switch (format) {
    case PictureFormat::png: return "memory.png";
    case PictureFormat::jpeg: return "memory.jpg";
    case PictureFormat::exr: return "memory.exr";
    case PictureFormat::hdr: return "memory.hdr";
    case PictureFormat::unknown: break;
  }
  assert(false);
  return "";
}

bool is_cut_off(PictureFormat format, std::string_view bytes) {
  if (format == PictureFormat::png) return is_png_cut_off(bytes);
  return format == PictureFormat::jpeg && is_jpeg_cut_off(bytes);
}

std::string reason_of(const std::string& text) { return text.empty() ? "it is broken." : text; }

Status check_size(const OIIO::ImageSpec& spec, std::size_t max_pixels) {
  if (spec.width <= 0 || spec.height <= 0 || spec.nchannels < 1 || spec.depth > 1 || spec.deep) {
    return unreadable("it has no pixels, or is no flat picture.");
  }
  if (spec.image_pixels() > max_pixels) {
    return unreadable("it has " + std::to_string(spec.width) + " x " + std::to_string(spec.height) +
                      " pixels; at most " + std::to_string(max_pixels) + " are allowed.");
  }
  return {};
}

}  // namespace

Result<OpenPicture> open_picture(std::span<const std::byte> bytes, std::span<const PictureFormat> wanted,
                                 std::size_t max_pixels) {
  const std::string_view text(reinterpret_cast<const char*>(bytes.data()), bytes.size());
  OpenPicture picture;
  picture.format = format_of(text);
  if (std::find(wanted.begin(), wanted.end(), picture.format) == wanted.end())
    return unreadable("it is neither " + list_of(wanted) + ".");
  if (is_cut_off(picture.format, text)) return unreadable("it is cut off.");
  const char* name = name_of(picture.format);
  picture.source = std::make_unique<OIIO::Filesystem::IOMemReader>(const_cast<std::byte*>(bytes.data()), bytes.size());
  OIIO::ImageSpec config;
  config.attribute("oiio:UnassociatedAlpha", 1);
  picture.input = OIIO::ImageInput::create(name, false, nullptr, picture.source.get());
  if (!picture.input) return unreadable(reason_of(OIIO::geterror()));
  OIIO::ImageInput& input = *picture.input;
  if (!input.set_ioproxy(picture.source.get()) || !input.open(name, picture.spec, config))
    return unreadable(reason_of(input.geterror()));
  if (Status status = check_size(picture.spec, max_pixels); !status.ok()) return status;
  input.threads(1);
  return picture;
}

Status unreadable_pixels(const OIIO::ImageInput& input) { return unreadable(reason_of(input.geterror())); }

std::string write_picture(PictureFormat format, const OIIO::ImageSpec& spec, const OIIO::TypeDesc& type,
                          const void* pixels) {
  std::vector<unsigned char> bytes;
  OIIO::Filesystem::IOVecOutput sink(bytes);
  const char* name = name_of(format);
  const auto output = OIIO::ImageOutput::create(name, &sink);
  assert(output);
  const bool written = output->open(name, spec) && output->write_image(type, pixels) && output->close();
  assert(written);
  return written ? std::string(bytes.begin(), bytes.end()) : std::string();
}

}  // namespace pelage
