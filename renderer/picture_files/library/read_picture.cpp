#include <algorithm>
#include <array>
#include <cassert>
#include <limits>
#include <string_view>
#include <vector>

#include "renderer/image/npy.h"
#include "renderer/picture_files/library/members.h"
#include "renderer/picture_files/library/open_picture.h"

namespace pelage {

std::string text_in_picture(std::span<const std::byte> bytes, const std::string& key) {
  constexpr std::array wanted{PictureFormat::png, PictureFormat::exr};
  const Result<OpenPicture> file = open_picture(bytes, wanted, std::numeric_limits<std::size_t>::max());
  return file ? std::string(file->spec.get_string_attribute(key)) : std::string();
}

namespace {

/// Converts grey, grey with alpha, and colour with or without alpha to RGBA.
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

Result<Image> decode_image(std::span<const std::byte> bytes, std::size_t max_pixels) {
  constexpr std::array wanted{PictureFormat::png, PictureFormat::jpeg};
  const Result<OpenPicture> file = open_picture(bytes, wanted, max_pixels);
  if (!file) return file.status();
  const OIIO::ImageSpec& spec = file->spec;
  if (spec.nchannels > 4) return unreadable("it has an unknown number of channels.");
  std::vector<std::uint8_t> pixels(spec.image_pixels() * static_cast<std::size_t>(spec.nchannels));
  OIIO::ImageInput& input = *file->input;
  if (!input.read_image(0, 0, 0, spec.nchannels, OIIO::TypeDesc::UINT8, pixels.data()) || input.has_error())
    return unreadable_pixels(input);
  return Image{spec.width, spec.height, to_rgba(pixels, static_cast<std::size_t>(spec.nchannels))};
}

namespace {

/// Indices of R, G, B and A among a file's channels; grey has the same index three times. -1 if there is none.
using ChannelIndices = std::array<int, 4>;

int channel_index(const std::vector<std::string>& names, const std::string& name) {
  const auto found = std::find(names.begin(), names.end(), name);
  return found == names.end() ? -1 : static_cast<int>(found - names.begin());
}

/// Returns "beauty." for "beauty.R" and "" for "R".
std::string prefix_of(const std::string& channel) {
  const std::size_t dot = channel.rfind('.');
  return dot == std::string::npos ? "" : channel.substr(0, dot + 1);
}

ChannelIndices channels_of_aov(const std::vector<std::string>& names, const std::string& aov) {
  ChannelIndices indices;
  for (std::size_t k = 0; k < 4; ++k) indices[k] = channel_index(names, aov + "RGBA"[k]);
  if (indices[0] < 0 && indices[1] < 0 && indices[2] < 0) {
    const int grey = channel_index(names, aov + "Y");
    indices = {grey, grey, grey, indices[3]};
  }
  return indices;
}

bool has_colour(const ChannelIndices& indices) { return indices[0] >= 0 && indices[1] >= 0 && indices[2] >= 0; }

ChannelIndices channels_by_name(const std::vector<std::string>& names) {
  ChannelIndices indices = channels_of_aov(names, "");
  for (std::size_t i = 0; i < names.size() && !has_colour(indices); ++i) {
    indices = channels_of_aov(names, prefix_of(names[i]));
  }
  return indices;
}

/// Returns the channels by their order, for formats without channel names: grey, grey and alpha, RGB, RGBA.
ChannelIndices channels_by_count(int channels) {
  const bool grey = channels < 3, alpha = channels % 2 == 0;
  return {0, grey ? 0 : 1, grey ? 0 : 2, alpha ? channels - 1 : -1};
}

/// Reads the range that contains all these channels at once, because most readers cannot go back to the first row.
Status read_channels(OIIO::ImageInput& input, const ChannelIndices& indices, FloatImage& image) {
  constexpr int max = 16;
  const int last = *std::max_element(indices.begin(), indices.end());
  const int first = std::min({indices[0], indices[1], indices[2], indices[3] < 0 ? last : indices[3]});
  if (last - first >= max) return unreadable("its channels of colour are too far apart.");
  const std::size_t step = static_cast<std::size_t>(last - first) + 1, pixels = image.rgba.size() / 4;
  std::vector<float> read(pixels * step);
  if (!input.read_image(0, 0, first, last + 1, OIIO::TypeDesc::FLOAT, read.data()) || input.has_error()) {
    return unreadable_pixels(input);
  }
  for (std::size_t k = 0; k < 4; ++k) {
    if (indices[k] < 0) continue;
    const std::size_t offset = static_cast<std::size_t>(indices[k] - first);
    for (std::size_t i = 0; i < pixels; ++i) image.rgba[i * 4 + k] = read[i * step + offset];
  }
  return {};
}

/// A file's numbers and its metadata.
struct ReadFile {
  PictureFormat format = PictureFormat::unknown;
  OIIO::ImageSpec spec;
  FloatImage image;
};

Result<ReadFile> read_file(std::span<const std::byte> bytes, std::size_t max_pixels) {
  constexpr std::array wanted{PictureFormat::png, PictureFormat::jpeg, PictureFormat::exr, PictureFormat::hdr};
  Result<OpenPicture> file = open_picture(bytes, wanted, max_pixels);
  if (!file) return file.status();
  OIIO::ImageSpec& spec = file->spec;
  const bool named = file->format == PictureFormat::exr || spec.nchannels > 4;
  const ChannelIndices indices = named ? channels_by_name(spec.channelnames) : channels_by_count(spec.nchannels);
  if (!has_colour(indices)) return unreadable("it has no channels R, G and B, nor Y.");
  FloatImage image{spec.width, spec.height, std::vector<float>(spec.image_pixels() * 4, 1.0f)};
  if (Status status = read_channels(*file->input, indices, image); !status.ok()) return status;
  return ReadFile{file->format, std::move(spec), std::move(image)};
}

}  // namespace

Result<FloatImage> decode_float_image(std::span<const std::byte> bytes, std::size_t max_pixels) {
  Result<ReadFile> file = read_file(bytes, max_pixels);
  if (!file) return file.status();
  FloatImage& image = file->image;
  image.display_referred = file->format == PictureFormat::png || file->format == PictureFormat::jpeg;
  if (image.display_referred) make_linear_and_premultiplied(image);
  return std::move(image);
}

Result<DataImage> decode_data_image(std::span<const std::byte> bytes, std::size_t max_pixels, const std::string& key) {
  const std::string_view text(reinterpret_cast<const char*>(bytes.data()), bytes.size());
  if (is_npy(text)) return decode_npy(text, max_pixels);
  Result<ReadFile> file = read_file(bytes, max_pixels);
  if (!file) return file.status();
  const OIIO::ImageSpec& spec = file->spec;
  const int bits = spec.format == OIIO::TypeDesc::UINT8 ? 8 : spec.format == OIIO::TypeDesc::UINT16 ? 16 : 32;
  return DataImage{spec.width, spec.height, bits, std::move(file->image.rgba),
                   std::string(spec.get_string_attribute(key))};
}

}  // namespace pelage
