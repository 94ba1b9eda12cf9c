#include "renderer/frame/areas.h"

#include <algorithm>
#include <cmath>

namespace pelage {

namespace {

/// Returns where a range of pixels lies after resizing from `from` to `to` pixels, as [begin, end), with a margin for
/// the filter: the cubic of Catmull and Rom reads two pixels of the light to each side.
glm::ivec2 resized_range(int begin, int length, int from, int to) {
  const double scale = static_cast<double>(to) / from, beside = 2 * std::max(scale, 1.0);
  return {std::max(0, static_cast<int>(std::floor(begin * scale - beside)) - 1),
          std::min(to, static_cast<int>(std::ceil((begin + length) * scale + beside)) + 1)};
}

Area resized_area(const Area& area, glm::ivec2 from, glm::ivec2 to) {
  const glm::ivec2 across = resized_range(area.left, area.width, from.x, to.x);
  const glm::ivec2 down = resized_range(area.top, area.height, from.y, to.y);
  return {across.x, down.x, across.y - across.x, down.y - down.x};
}

}  // namespace

Area finished_area(const Area& area, glm::ivec2 light, glm::ivec2 picture) {
  return resized_area(area, light, picture);
}

Area drawn_area(const FurFrame& frame, glm::ivec2 light) {
  if (!frame.crop) return {0, 0, light.x, light.y};
  const Crop& crop = *frame.crop;
  return resized_area({crop.left, crop.top, crop.width, crop.height}, {frame.width, frame.height}, light);
}

Area common_area(const Area& a, const Area& b) {
  const int left = std::max(a.left, b.left), top = std::max(a.top, b.top);
  const int right = std::min(a.left + a.width, b.left + b.width);
  const int bottom = std::min(a.top + a.height, b.top + b.height);
  return right > left && bottom > top ? Area{left, top, right - left, bottom - top} : Area{};
}

}  // namespace pelage
