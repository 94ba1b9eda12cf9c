// The worker's answers for pictures: nine vectors of doubles, or width, height and bytes. Native byte order.
#include <cmath>
#include <cstring>

#include "protocol/base/limits.h"
#include "server/import/import.h"

namespace pelage {

namespace {

struct Sides {
  std::int32_t width = 0, height = 0;
};

bool is_side(std::int32_t pixels) { return pixels >= 1 && pixels <= limits::picture_pixels; }

bool is_harmonic(double value) { return std::abs(value) <= limits::harmonic; }  // false for NaN

}  // namespace

std::string encode_harmonics(const SphericalHarmonics& harmonics) {
  return {reinterpret_cast<const char*>(harmonics.data()), sizeof harmonics};
}

Result<SphericalHarmonics> decode_harmonics(std::span<const std::byte> bytes) {
  SphericalHarmonics harmonics{};
  if (bytes.size() != sizeof harmonics) return failure(Code::invalid, "The bytes are no spherical harmonics.");
  std::memcpy(harmonics.data(), bytes.data(), bytes.size());
  for (const glm::dvec3& v : harmonics) {
    if (!is_harmonic(v.x) || !is_harmonic(v.y) || !is_harmonic(v.z)) {
      return failure(Code::invalid, "A spherical harmonic is out of range.");
    }
  }
  return harmonics;
}

std::string encode_raw_image(const RawImage& image) {
  const Sides sides{image.width, image.height};
  std::string bytes(reinterpret_cast<const char*>(&sides), sizeof sides);
  return bytes.append(reinterpret_cast<const char*>(image.rgba.data()), image.rgba.size());
}

Result<RawImage> decode_raw_image(std::span<const std::byte> bytes) {
  Sides sides;
  if (bytes.size() >= sizeof sides) std::memcpy(&sides, bytes.data(), sizeof sides);
  if (!is_side(sides.width) || !is_side(sides.height)) {
    return failure(Code::invalid, "The sides of the picture are out of range.");
  }
  const auto pixels = static_cast<std::size_t>(sides.width) * static_cast<std::size_t>(sides.height);
  if (bytes.size() != sizeof sides + 4 * pixels) return failure(Code::invalid, "The picture's bytes do not fit it.");
  RawImage image{sides.width, sides.height, std::vector<std::uint8_t>(4 * pixels)};
  std::memcpy(image.rgba.data(), bytes.data() + sizeof sides, image.rgba.size());
  return image;
}

}  // namespace pelage
