// The encoding of map pictures: a header, then the samples in the bit depth of the file. Native byte order.
#include "server/import/map_picture.h"

#include <cmath>
#include <cstdint>
#include <cstring>

#include "base/limits.h"

namespace pelage {

namespace {

constexpr std::uint64_t map_signature =
    0x31'50'41'4d'4c'45'50ULL;  // "PELMAP1"; no bytes of encode_raw_image begin with it

struct Header {
  std::uint64_t mark = map_signature;
  std::int32_t width = 0, height = 0, bits = 0, unused = 0;
  double scale = 0;  // 0 for none
};

template <class Sample>
void append(std::string& bytes, const std::vector<float>& rgba, float max) {
  std::vector<Sample> samples;
  samples.reserve(rgba.size());
  for (const float value : rgba) samples.push_back(static_cast<Sample>(std::lround(value * max)));
  bytes.append(reinterpret_cast<const char*>(samples.data()), samples.size() * sizeof(Sample));
}

template <class Sample>
void take(std::span<const std::byte> bytes, std::vector<float>& rgba, float max) {
  for (std::size_t i = 0; i < rgba.size(); ++i) {
    Sample sample;
    std::memcpy(&sample, bytes.data() + i * sizeof sample, sizeof sample);
    rgba[i] = static_cast<float>(sample) / max;
  }
}

/// Returns whether the sides are allowed. A picture one pixel wide is a list of vertices, which has as many rows as it
/// likes but no more pixels than a picture may have.
bool are_sides(std::int32_t width, std::int32_t height) {
  constexpr std::int32_t max_side = limits::picture_pixels, max_rows = max_side * max_side;
  return width >= 1 && width <= max_side && height >= 1 && height <= (width == 1 ? max_rows : max_side);
}

bool is_good(const Header& header) {
  const bool known = header.bits == 8 || header.bits == 16 || header.bits == 32;
  return header.mark == map_signature && are_sides(header.width, header.height) && known &&
         std::isfinite(header.scale) && header.scale >= 0;
}

Status misfit() { return failure(Code::invalid, "The bytes are no picture of a map."); }

Result<MapPicture> from_raw_image(std::span<const std::byte> bytes) {
  const Result<RawImage> image = decode_raw_image(bytes);
  if (!image) return misfit();
  MapPicture picture{image->width, image->height, 8, {}, {}};
  picture.rgba.reserve(image->rgba.size());
  for (const std::uint8_t value : image->rgba) picture.rgba.push_back(static_cast<float>(value) / 255.0f);
  return picture;
}

}  // namespace

std::string encode_map_picture(const MapPicture& picture) {
  const Header header{map_signature, picture.width, picture.height, picture.bits, 0, picture.scale.value_or(0)};
  std::string bytes(reinterpret_cast<const char*>(&header), sizeof header);
  bytes.reserve(sizeof header + picture.rgba.size() * static_cast<std::size_t>(picture.bits) / 8);
  if (picture.bits == 8)
    append<std::uint8_t>(bytes, picture.rgba, 255);
  else if (picture.bits == 16)
    append<std::uint16_t>(bytes, picture.rgba, 65535);
  else
    bytes.append(reinterpret_cast<const char*>(picture.rgba.data()), picture.rgba.size() * sizeof(float));
  return bytes;
}

Result<MapPicture> decode_map_picture(std::span<const std::byte> bytes) {
  Header header{0};
  if (bytes.size() >= sizeof header) std::memcpy(&header, bytes.data(), sizeof header);
  if (header.mark != map_signature) return from_raw_image(bytes);
  if (!is_good(header)) return misfit();
  const std::size_t samples = 4 * static_cast<std::size_t>(header.width) * static_cast<std::size_t>(header.height);
  const auto sample_bytes = static_cast<std::size_t>(header.bits) / 8;
  bytes = bytes.subspan(sizeof header);
  if (bytes.size() != samples * sample_bytes) return misfit();
  MapPicture picture{header.width, header.height, header.bits, {}, std::vector<float>(samples)};
  if (header.scale > 0) picture.scale = header.scale;
  if (header.bits == 8)
    take<std::uint8_t>(bytes, picture.rgba, 255);
  else if (header.bits == 16)
    take<std::uint16_t>(bytes, picture.rgba, 65535);
  else
    std::memcpy(picture.rgba.data(), bytes.data(), bytes.size());
  for (const float value : picture.rgba) {
    if (!std::isfinite(value)) return misfit();
  }
  return picture;
}

}  // namespace pelage
