#include <algorithm>
#include <cassert>
#include <cmath>
#include <cstdio>
#include <cstring>
#include <vector>

#include "renderer/picture_files/library/members.h"
#include "renderer/picture_files/library/open_picture.h"

namespace pelage {

namespace {

std::vector<std::uint8_t> without_alpha(const std::vector<std::uint8_t>& rgba) {
  std::vector<std::uint8_t> rgb(rgba.size() / 4 * 3);
  for (std::size_t from = 0, to = 0; from < rgba.size(); from += 4, to += 3) {
    rgb[to] = rgba[from], rgb[to + 1] = rgba[from + 1], rgb[to + 2] = rgba[from + 2];
  }
  return rgb;
}

}  // namespace

std::string encode_jpeg(const Image& image, int quality) {
  assert(image.width > 0 && image.height > 0 && quality >= 1 && quality <= 100);
  OIIO::ImageSpec spec(image.width, image.height, 3, OIIO::TypeDesc::UINT8);
  spec.attribute("Compression", "jpeg:" + std::to_string(quality));
  spec.attribute("oiio:ColorSpace", "sRGB");
  return write_picture(PictureFormat::jpeg, spec, spec.format, without_alpha(image.rgba).data());
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
  if (window.camera) {
    spec.attribute("worldToCamera", OIIO::TypeMatrix44, window.camera->world_to_camera.data());
    spec.attribute("worldToNDC", OIIO::TypeMatrix44, window.camera->world_to_ndc.data());
  }
  spec.attribute("compression", "zip");
  spec.attribute("DateTime", "");  // otherwise the writer adds the current time, and no two files are equal
  for (const ImageText& text : texts) {
    const bool is_rate = text.key == frame_rate_text;
    int rate[2] = {0, 1};
    if (is_rate && std::sscanf(text.value.c_str(), "%d/%d", &rate[0], &rate[1]) > 0)
      spec.attribute("framesPerSecond", OIIO::TypeRational, rate);  // the standard's spelling
    if (!is_rate) spec.attribute(text.key, text.value);
  }
  return spec;
}

float within_half(float value) { return std::isfinite(value) ? std::clamp(value, -largest_half, largest_half) : value; }

/// Returns the pixels one by one, each channel in its own type, as the file stores them.
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

[[maybe_unused]] bool are_complete(std::size_t pixels, std::span<const ExrPlane> planes) {
  return !planes.empty() && std::all_of(planes.begin(), planes.end(), [&](const ExrPlane& plane) {
    return !plane.channel.empty() && plane.offset + (pixels - 1) * plane.stride < plane.values.size();
  });
}

}  // namespace

std::string encode_exr(const ExrWindow& window, std::span<const ExrPlane> planes, std::span<const ImageText> texts) {
  assert(window.width > 0 && window.height > 0);
  const OIIO::ImageSpec spec = exr_spec(window, planes, texts);
  assert(are_complete(spec.image_pixels(), planes));
  return write_picture(PictureFormat::exr, spec, OIIO::TypeDesc::UNKNOWN, native_pixels(spec, planes).data());
}

}  // namespace pelage
