#include <OpenImageIO/imageio.h>

#include <algorithm>
#include <cassert>
#include <cmath>
#include <cstring>

#include "renderer/image/float_image.h"
#include "renderer/image/bytes.h"

namespace pelage {

namespace {

constexpr float largest_half = 65504;

OIIO::TypeDesc type_of(ExrSample sample) {
  return sample == ExrSample::half ? OIIO::TypeDesc::HALF : OIIO::TypeDesc::FLOAT;
}

OIIO::ImageSpec exr_spec(int width, int height, std::span<const ExrPlane> planes, std::span<const ImageText> texts) {
  OIIO::ImageSpec spec(width, height, static_cast<int>(planes.size()), OIIO::TypeDesc::FLOAT);
  spec.channelnames.clear();
  for (const ExrPlane& plane : planes) {
    spec.channelnames.push_back(plane.channel);
    spec.channelformats.push_back(type_of(plane.sample));
  }
  spec.attribute("compression", "zip");
  spec.attribute("DateTime", "");  // or the writer adds the present time, and no two files are equal
  for (const ImageText& text : texts) spec.attribute(text.key, text.value);
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

std::vector<ExrPlane> rgba_planes(std::span<const float> rgba, ExrSample sample, const std::string& layer) {
  const std::string prefix = layer.empty() ? "" : layer + ".";
  std::vector<ExrPlane> planes;
  for (std::size_t k = 0; k < 4; ++k) planes.push_back({prefix + "RGBA"[k], rgba, k, 4, sample});
  return planes;
}

std::string encode_exr(int width, int height, std::span<const ExrPlane> planes, std::span<const ImageText> texts) {
  assert(width > 0 && height > 0);
  const OIIO::ImageSpec spec = exr_spec(width, height, planes, texts);
  assert(are_whole(spec.image_pixels(), planes));
  return write_picture(PictureFormat::exr, spec, OIIO::TypeDesc::UNKNOWN, native_pixels(spec, planes).data());
}

}  // namespace pelage
