#include "renderer/image/float_image.h"

#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>
#include <cstdio>
#include <cstring>
#include <string_view>

#include "protocol/base/colour_space.h"
#include "renderer/image/image.h"
#include "renderer/image/npy.h"

namespace pelage {

namespace {

/// Places of R, G, B and A among a file's channels; grey names one place three times. -1 where there is none.
using Places = std::array<int, 4>;

int place_of(const std::vector<std::string>& names, const std::string& name) {
  const auto found = std::find(names.begin(), names.end(), name);
  return found == names.end() ? -1 : static_cast<int>(found - names.begin());
}

/// "beauty." of "beauty.R"; "" of "R".
std::string prefix_of(const std::string& channel) {
  const std::size_t dot = channel.rfind('.');
  return dot == std::string::npos ? "" : channel.substr(0, dot + 1);
}

Places places_of_aov(const std::vector<std::string>& names, const std::string& aov) {
  Places places;
  for (std::size_t k = 0; k < 4; ++k) places[k] = place_of(names, aov + "RGBA"[k]);
  if (places[0] < 0 && places[1] < 0 && places[2] < 0) {
    const int grey = place_of(names, aov + "Y");
    places = {grey, grey, grey, places[3]};
  }
  return places;
}

bool has_colour(const Places& places) { return places[0] >= 0 && places[1] >= 0 && places[2] >= 0; }

Places places_by_name(const std::vector<std::string>& names) {
  Places places = places_of_aov(names, "");
  for (std::size_t i = 0; i < names.size() && !has_colour(places); ++i) {
    places = places_of_aov(names, prefix_of(names[i]));
  }
  return places;
}

/// By position, for formats without names of channels: grey, grey and alpha, RGB, RGBA.
Places places_by_count(int channels) {
  const bool grey = channels < 3, alpha = channels % 2 == 0;
  return {0, grey ? 0 : 1, grey ? 0 : 2, alpha ? channels - 1 : -1};
}

/// Reads the range of channels that holds all places at once: most readers cannot go back to the first row.
Status read_channels(OIIO::ImageInput& input, const Places& places, FloatImage& image) {
  constexpr int max = 16;
  const int last = *std::max_element(places.begin(), places.end());
  const int first = std::min({places[0], places[1], places[2], places[3] < 0 ? last : places[3]});
  if (last - first >= max) return unreadable("its channels of colour are too far apart.");
  const std::size_t step = static_cast<std::size_t>(last - first) + 1, pixels = image.rgba.size() / 4;
  std::vector<float> read(pixels * step);
  if (!input.read_image(0, 0, first, last + 1, OIIO::TypeDesc::FLOAT, read.data()) || input.has_error()) {
    return unreadable(reason_of(input.geterror()));
  }
  for (std::size_t k = 0; k < 4; ++k) {
    if (places[k] < 0) continue;
    const std::size_t offset = static_cast<std::size_t>(places[k] - first);
    for (std::size_t i = 0; i < pixels; ++i) image.rgba[i * 4 + k] = read[i * step + offset];
  }
  return {};
}

void make_linear_and_premultiplied(FloatImage& image) {
  for (std::size_t i = 0; i < image.rgba.size(); i += 4) {
    for (std::size_t k = 0; k < 3; ++k) {
      image.rgba[i + k] = static_cast<float>(linear_from_srgb(image.rgba[i + k]) * image.rgba[i + 3]);
    }
  }
}

}  // namespace

FloatImage linear_image(const Image& image) {
  FloatImage linear{image.width, image.height, std::vector<float>(image.rgba.size()), true};
  std::transform(image.rgba.begin(), image.rgba.end(), linear.rgba.begin(),
                 [](std::uint8_t value) { return static_cast<float>(value) * (1.0f / 255); });
  make_linear_and_premultiplied(linear);
  return linear;
}

void read_exr_without_threads() { OIIO::attribute("exr_threads", -1); }

namespace {

/// A file's numbers and what it says about them.
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
  const Places places = named ? places_by_name(spec.channelnames) : places_by_count(spec.nchannels);
  if (!has_colour(places)) return unreadable("it has no channels R, G and B, nor Y.");
  FloatImage image{spec.width, spec.height, std::vector<float>(spec.image_pixels() * 4, 1.0f)};
  if (Status status = read_channels(*file->input, places, image); !status.ok()) return status;
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

namespace {

constexpr float largest_half = 65504;

OIIO::TypeDesc type_of(ExrSample sample) {
  return sample == ExrSample::half ? OIIO::TypeDesc::HALF : OIIO::TypeDesc::FLOAT;
}

OIIO::ImageSpec exr_spec(const ExrWindow& window, std::span<const ExrPlane> planes, std::span<const ImageText> texts) {
  OIIO::ImageSpec spec(window.width, window.height, static_cast<int>(planes.size()), OIIO::TypeDesc::FLOAT);
  spec.x = window.left, spec.y = window.top;
  if (window.full_width > 0) spec.full_width = window.full_width, spec.full_height = window.full_height;
  spec.channelnames.clear();
  for (const ExrPlane& plane : planes) {
    spec.channelnames.push_back(plane.channel);
    spec.channelformats.push_back(type_of(plane.sample));
  }
  spec.attribute("compression", "zip");
  spec.attribute("DateTime", "");  // or the writer adds the present time, and no two files are equal
  for (const ImageText& text : texts) {
    const bool is_rate = text.key == frame_rate_text;
    int rate[2] = {0, 1};
    if (is_rate && std::sscanf(text.value.c_str(), "%d/%d", &rate[0], &rate[1]) > 0)
      spec.attribute("framesPerSecond", OIIO::TypeRational, rate);  // as the standard writes it
    if (!is_rate) spec.attribute(text.key, text.value);
  }
  return spec;
}

float within_half(float value) { return std::isfinite(value) ? std::clamp(value, -largest_half, largest_half) : value; }

/// Pixel by pixel, each channel in its own type, as the file keeps them.
std::vector<std::byte> native_pixels(const OIIO::ImageSpec& spec, std::span<const ExrPlane> planes) {
  const std::size_t pixel_bytes = spec.pixel_bytes(true), pixels = spec.image_pixels();
  std::vector<std::byte> bytes(pixels * pixel_bytes);
  std::size_t at = 0;
  for (const ExrPlane& plane : planes) {
    const OIIO::TypeDesc type = type_of(plane.sample);
    std::vector<float> values(pixels);
    for (std::size_t i = 0; i < pixels; ++i) {
      const float value = plane.values[plane.offset + i * plane.stride];
      values[i] = plane.sample == ExrSample::half ? within_half(value) : value;
    }
    std::vector<std::byte> native(pixels * type.size());
    OIIO::convert_pixel_values(OIIO::TypeDesc::FLOAT, values.data(), type, native.data(), static_cast<int>(pixels));
    for (std::size_t i = 0; i < pixels; ++i) {
      std::memcpy(&bytes[i * pixel_bytes + at], &native[i * type.size()], type.size());
    }
    at += type.size();
  }
  return bytes;
}

[[maybe_unused]] bool are_whole(std::size_t pixels, std::span<const ExrPlane> planes) {
  return !planes.empty() && std::all_of(planes.begin(), planes.end(), [&](const ExrPlane& plane) {
    return !plane.channel.empty() && plane.offset + (pixels - 1) * plane.stride < plane.values.size();
  });
}

}  // namespace

std::vector<ExrPlane> rgba_planes(std::span<const float> rgba, ExrSample sample, const std::string& aov) {
  const std::string prefix = aov.empty() ? "" : aov + ".";
  std::vector<ExrPlane> planes;
  for (std::size_t k = 0; k < 4; ++k) planes.push_back({prefix + "RGBA"[k], rgba, k, 4, sample});
  return planes;
}

std::string encode_exr(const ExrWindow& window, std::span<const ExrPlane> planes, std::span<const ImageText> texts) {
  assert(window.width > 0 && window.height > 0);
  const OIIO::ImageSpec spec = exr_spec(window, planes, texts);
  assert(are_whole(spec.image_pixels(), planes));
  return write_picture(PictureFormat::exr, spec, OIIO::TypeDesc::UNKNOWN, native_pixels(spec, planes).data());
}

}  // namespace pelage
