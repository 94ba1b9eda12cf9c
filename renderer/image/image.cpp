#include "renderer/image/image.h"

#include <OpenImageIO/filesystem.h>
#include <OpenImageIO/imageio.h>

#include <cassert>
#include <memory>
#include <string_view>

#include "renderer/image/bytes.h"
#include "renderer/image/png_bands.h"

namespace pelage {

namespace {

std::vector<std::uint8_t> without_alpha(const std::vector<std::uint8_t>& rgba) {
  std::vector<std::uint8_t> rgb(rgba.size() / 4 * 3);
  for (std::size_t from = 0, to = 0; from < rgba.size(); from += 4, to += 3) {
    rgb[to] = rgba[from], rgb[to + 1] = rgba[from + 1], rgb[to + 2] = rgba[from + 2];
  }
  return rgb;
}

template <class Picture>
std::string encode_png_of(const Picture& image, bool keep_alpha, std::span<const ImageText> texts, PngNumbers numbers) {
  const PngLayout layout = png_layout(image, keep_alpha);
  std::vector<std::shared_ptr<const PngBand>> bands;
  for (int band = 0; band < png_band_count(layout); ++band) {
    bands.push_back(std::make_shared<const PngBand>(png_band(layout, png_band_of(image, band))));
  }
  return png_file(layout, bands, texts, numbers);
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

}  // namespace

std::string encode_png(const Image& image, bool keep_alpha, std::span<const ImageText> texts, PngNumbers numbers) {
  return encode_png_of(image, keep_alpha, texts, numbers);
}

std::string encode_png(const Image16& image, bool keep_alpha, std::span<const ImageText> texts, PngNumbers numbers) {
  return encode_png_of(image, keep_alpha, texts, numbers);
}

std::string encode_jpeg(const Image& image, int quality) {
  assert(image.width > 0 && image.height > 0 && quality >= 1 && quality <= 100);
  OIIO::ImageSpec spec(image.width, image.height, 3, OIIO::TypeDesc::UINT8);
  spec.attribute("Compression", "jpeg:" + std::to_string(quality));
  spec.attribute("oiio:ColorSpace", "sRGB");
  return write_picture(PictureFormat::jpeg, spec, spec.format, without_alpha(image.rgba).data());
}

Result<Image> decode_image(std::span<const std::byte> bytes, std::size_t max_pixels) {
  const std::string_view text(reinterpret_cast<const char*>(bytes.data()), bytes.size());
  const PictureFormat format = format_of(text);
  if (format != PictureFormat::png && format != PictureFormat::jpeg) return unreadable("it is neither PNG nor JPEG.");
  if (is_cut_off(format, text)) return unreadable("it is cut off.");

  const char* name = name_of(format);
  OIIO::Filesystem::IOMemReader source(const_cast<std::byte*>(bytes.data()), bytes.size());
  OIIO::ImageSpec wishes;
  wishes.attribute("oiio:UnassociatedAlpha", 1);
  const auto input = OIIO::ImageInput::create(name, false, nullptr, &source);
  if (!input) return unreadable(reason_of(OIIO::geterror()));
  OIIO::ImageSpec spec;
  if (!input->set_ioproxy(&source) || !input->open(name, spec, wishes)) return unreadable(reason_of(input->geterror()));
  if (Status status = check_size(spec, max_pixels); !status.ok()) return status;
  if (spec.nchannels > 4) return unreadable("it has an unknown number of channels.");

  input->threads(1);
  std::vector<std::uint8_t> pixels(spec.image_pixels() * static_cast<std::size_t>(spec.nchannels));
  if (!input->read_image(0, 0, 0, spec.nchannels, OIIO::TypeDesc::UINT8, pixels.data()) || input->has_error()) {
    return unreadable(reason_of(input->geterror()));
  }
  return Image{spec.width, spec.height, to_rgba(pixels, static_cast<std::size_t>(spec.nchannels))};
}

}  // namespace pelage
