#include "renderer/compare/mask.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <functional>

#include "renderer/compare/colour.h"

namespace pelage {

namespace {

template <class Inside>
Mask mask_of(const FloatImage& image, Inside inside) {
  Mask mask{image.width, image.height, std::vector<std::uint8_t>(image.rgba.size() / 4)};
  for (std::size_t i = 0; i < mask.inside.size(); ++i) mask.inside[i] = inside(&image.rgba[i * 4]) ? 1 : 0;
  return mask;
}

/// For each pixel how far along its row the nearest pixel of this side is; `far` where there is none within reach.
std::vector<int> row_distances(const Mask& mask, std::uint8_t side, int far) {
  std::vector<int> distances(mask.inside.size());
  const std::size_t width = static_cast<std::size_t>(mask.width);
  for (std::size_t begin = 0; begin < distances.size(); begin += width) {
    int distance = far;
    for (std::size_t i = begin; i < begin + width; ++i) {
      distance = mask.inside[i] == side ? 0 : std::min(distance + 1, far);
      distances[i] = distance;
    }
    distance = far;
    for (std::size_t i = begin + width; i-- > begin;) {
      distance = mask.inside[i] == side ? 0 : std::min(distance + 1, far);
      distances[i] = std::min(distances[i], distance);
    }
  }
  return distances;
}

}  // namespace

std::size_t Mask::count() const { return static_cast<std::size_t>(std::count(inside.begin(), inside.end(), 1)); }

Mask alpha_mask(const FloatImage& image) {
  constexpr float least = 0.999f / 255;  // a rounded 1/255 counts
  return mask_of(image, [](const float* rgba) { return rgba[3] >= least; });
}

Mask luminance_mask(const FloatImage& image) {
  const double half = linear_from_srgb(0.5);
  return mask_of(image, [half](const float* rgba) { return luminance_of({rgba[0], rgba[1], rgba[2]}) > half; });
}

Mask union_of(const Mask& first, const Mask& second) {
  assert(first.width == second.width && first.height == second.height);
  Mask both = first;
  std::transform(first.inside.begin(), first.inside.end(), second.inside.begin(), both.inside.begin(),
                 std::bit_or<std::uint8_t>());
  return both;
}

Mask outline_band(const Mask& mask, double pixels) {
  assert(pixels >= 0 && pixels <= 1000);
  const int reach = static_cast<int>(pixels), far = reach + 1;
  const std::vector<int> to_outside = row_distances(mask, 0, far), to_inside = row_distances(mask, 1, far);
  Mask band{mask.width, mask.height, std::vector<std::uint8_t>(mask.inside.size())};
  const auto index = [&](int x, int y) {
    return static_cast<std::size_t>(y) * static_cast<std::size_t>(mask.width) + static_cast<std::size_t>(x);
  };
  for (int y = 0; y < mask.height; ++y) {
    for (int row = std::max(0, y - reach); row <= std::min(mask.height - 1, y + reach); ++row) {
      const double farthest = std::sqrt(pixels * pixels - (row - y) * (row - y));
      for (int x = 0; x < mask.width; ++x) {
        const std::vector<int>& distances = mask.inside[index(x, y)] ? to_outside : to_inside;
        if (distances[index(x, row)] <= farthest) band.inside[index(x, y)] = 1;
      }
    }
  }
  return band;
}

}  // namespace pelage
