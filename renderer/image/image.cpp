#include "renderer/image/image.h"

#include <OpenImageIO/filesystem.h>
#include <OpenImageIO/imageio.h>

#include <algorithm>
#include <array>
#include <cassert>
#include <memory>
#include <string_view>

namespace pelage {

namespace {

std::vector<std::uint8_t> without_alpha(const Image& image) {
  std::vector<std::uint8_t> rgb;
  rgb.reserve(image.rgba.size() / 4 * 3);
  for (std::size_t i = 0; i < image.rgba.size(); i += 4) {
    rgb.insert(rgb.end(), {image.rgba[i], image.rgba[i + 1], image.rgba[i + 2]});
  }
  return rgb;
}

bool is_opaque(const Image& image) {
  for (std::size_t i = 3; i < image.rgba.size(); i += 4) {
    if (image.rgba[i] != 255) return false;
  }
  return true;
}

OIIO::ImageSpec png_spec(const Image& image, int channels, std::span<const ImageText> texts) {
  constexpr int sub_filter = 16;  // PNG_FILTER_SUB
  OIIO::ImageSpec spec(image.width, image.height, channels, OIIO::TypeDesc::UINT8);
  spec.attribute("png:compressionLevel", 1);
  spec.attribute("png:filter", sub_filter);
  spec.attribute("oiio:ColorSpace", "sRGB");
  spec.attribute("oiio:UnassociatedAlpha", 1);
  for (const ImageText& text : texts) spec.attribute(text.key, text.value);
  return spec;
}

/// The file's name as OpenImageIO wants it to choose a reader; empty when the octets are neither PNG nor JPEG.
std::string name_by_signature(std::string_view octets) {
  using namespace std::string_view_literals;
  if (octets.starts_with("\x89PNG\r\n\x1a\n"sv)) return "memory.png";
  if (octets.starts_with("\xff\xd8\xff"sv)) return "memory.jpg";
  return {};
}

/// Whether the chunks of a PNG end before IEND.
bool is_png_cut_off(std::string_view octets) {
  constexpr std::size_t signature = 8, frame = 12;  // of a chunk: its length, its name, its checksum
  octets.remove_prefix(signature);
  while (octets.size() >= frame) {
    std::size_t length = 0;
    for (std::size_t i = 0; i < 4; ++i) length = length << 8 | static_cast<unsigned char>(octets[i]);
    if (length > octets.size() - frame) return true;
    if (octets.substr(4, 4) == "IEND") return false;
    octets.remove_prefix(frame + length);
  }
  return true;
}

/// Whether a JPEG has no end marker after its last scan: libjpeg fills what is missing with grey and goes on.
bool is_jpeg_cut_off(std::string_view octets) {
  const std::size_t scan = octets.rfind("\xff\xda"), end = octets.rfind("\xff\xd9");
  return scan == std::string_view::npos || end == std::string_view::npos || end < scan;
}

/// Grey, grey with alpha, or colour without alpha to RGBA.
std::vector<std::uint8_t> to_rgba(const std::vector<std::uint8_t>& pixels, std::size_t channels) {
  std::vector<std::uint8_t> rgba;
  rgba.reserve(pixels.size() / channels * 4);
  const bool grey = channels < 3, alpha = channels % 2 == 0;
  for (std::size_t i = 0; i < pixels.size(); i += channels) {
    const std::uint8_t* p = &pixels[i];
    rgba.insert(rgba.end(),
                {p[0], grey ? p[0] : p[1], grey ? p[0] : p[2], alpha ? p[channels - 1] : std::uint8_t{255}});
  }
  return rgba;
}

Status refusal(const std::string& reason) { return failure(Code::invalid, "The picture cannot be read: " + reason); }

std::string reason_of(const std::string& text) { return text.empty() ? "it is broken." : text; }

Status check_size(const OIIO::ImageSpec& spec, std::size_t max_pixels) {
  if (spec.width <= 0 || spec.height <= 0 || spec.nchannels < 1 || spec.nchannels > 4 || spec.depth > 1) {
    return refusal("it has no pixels or an unknown number of channels.");
  }
  if (spec.image_pixels() > max_pixels) {
    return refusal("it has " + std::to_string(spec.width) + " x " + std::to_string(spec.height) + " pixels; at most " +
                   std::to_string(max_pixels) + " are allowed.");
  }
  return {};
}

}  // namespace

std::string encode_png(const Image& image, bool keep_alpha, std::span<const ImageText> texts) {
  assert(image.width > 0 && image.height > 0);
  assert(image.rgba.size() ==
         std::size_t{4} * static_cast<std::size_t>(image.width) * static_cast<std::size_t>(image.height));
  const bool rgb = !keep_alpha && is_opaque(image);
  std::vector<unsigned char> octets;
  OIIO::Filesystem::IOVecOutput sink(octets);
  const auto output = OIIO::ImageOutput::create("memory.png", &sink);
  assert(output);
  bool written = output->open("memory.png", png_spec(image, rgb ? 3 : 4, texts));
  const std::vector<std::uint8_t> opaque = rgb ? without_alpha(image) : std::vector<std::uint8_t>();
  const void* pixels = rgb ? opaque.data() : image.rgba.data();
  written = written && output->write_image(OIIO::TypeDesc::UINT8, pixels) && output->close();
  assert(written);
  return written ? std::string(octets.begin(), octets.end()) : std::string();
}

Result<Image> decode_image(std::span<const std::byte> octets, std::size_t max_pixels) {
  const std::string_view text(reinterpret_cast<const char*>(octets.data()), octets.size());
  const std::string name = name_by_signature(text);
  if (name.empty()) return refusal("it is neither PNG nor JPEG.");
  const bool is_png = name == "memory.png";
  if (is_png ? is_png_cut_off(text) : is_jpeg_cut_off(text)) return refusal("it is cut off.");

  OIIO::Filesystem::IOMemReader source(const_cast<std::byte*>(octets.data()), octets.size());
  OIIO::ImageSpec wishes;
  wishes.attribute("oiio:UnassociatedAlpha", 1);
  const auto input = OIIO::ImageInput::create(name, false, nullptr, &source);
  if (!input) return refusal(reason_of(OIIO::geterror()));
  OIIO::ImageSpec spec;
  if (!input->set_ioproxy(&source) || !input->open(name, spec, wishes)) return refusal(reason_of(input->geterror()));
  if (Status status = check_size(spec, max_pixels); !status.ok()) return status;

  input->threads(1);
  std::vector<std::uint8_t> pixels(spec.image_pixels() * static_cast<std::size_t>(spec.nchannels));
  if (!input->read_image(0, 0, 0, spec.nchannels, OIIO::TypeDesc::UINT8, pixels.data()) || input->has_error()) {
    return refusal(reason_of(input->geterror()));
  }
  return Image{spec.width, spec.height, to_rgba(pixels, static_cast<std::size_t>(spec.nchannels))};
}

}  // namespace pelage
