#include <algorithm>
#include <cstdlib>

#include "server/maps/map_image.h"
#include "protocol/base/parallel.h"

namespace pelage {

namespace {

constexpr std::int8_t none = 127;  // farther than any distance that is asked for

/// For each pixel of a row how far to the right its nearest covered pixel in that row is; `none` beyond the distance.
void find_in_row(const std::uint8_t* covered, int size, int distance, std::int8_t* steps) {
  const auto seek = [&](int from, int to, int step) {
    int last = -1;
    for (int x = from; x != to; x += step) {
      if (covered[x]) last = x;
      const int far = last < 0 ? none : std::abs(last - x);
      if (far <= distance && far < std::abs(int{steps[x]})) steps[x] = static_cast<std::int8_t>(last - x);
    }
  };
  std::fill(steps, steps + size, none);
  seek(0, size, 1);
  seek(size - 1, -1, -1);
}

}  // namespace

// Nearest along each row first, then over the rows: Felzenszwalb and Huttenlocher's two passes, cut at the distance.
void dilate(MapImage& image, int distance) {
  if (distance <= 0) return;
  const auto size = static_cast<std::size_t>(image.size);
  std::vector<std::int8_t> steps(size * size);
  std::vector<std::uint8_t> grown = image.covered;
  const auto rows = static_cast<std::uint32_t>(image.size);
  for_each_in_parallel(rows, [&](std::uint32_t y) {
    find_in_row(&image.covered[y * size], image.size, distance, &steps[y * size]);
  });
  const auto fill = [&](int x, int y) {
    const std::size_t here = static_cast<std::size_t>(y) * size + static_cast<std::size_t>(x);
    int nearest = distance * distance + 1;
    std::size_t source = here;
    const auto look = [&](int row) {
      if (row < 0 || row >= image.size) return;
      const std::size_t there = static_cast<std::size_t>(row) * size + static_cast<std::size_t>(x);
      const int step = steps[there], far = step * step + (row - y) * (row - y);
      if (step == none || far >= nearest) return;
      nearest = far;
      source = there + static_cast<std::size_t>(static_cast<std::ptrdiff_t>(step));
    };
    for (int down = 0; down * down < nearest; ++down) look(y - down), look(y + down);
    if (source == here) return;
    std::copy_n(image.at(source), image.channels, image.at(here));
    grown[here] = 1;
  };
  for_each_in_parallel(rows, [&](std::uint32_t y) {
    for (int x = 0; x < image.size; ++x) {
      if (!image.covered[y * size + static_cast<std::size_t>(x)]) fill(x, static_cast<int>(y));
    }
  });
  image.covered = std::move(grown);
}

}  // namespace pelage
