#include <algorithm>
#include <cmath>

#include "server/maps/bilinear.h"
#include "server/maps/map_image.h"
#include "protocol/base/parallel.h"

namespace pelage {

namespace {

constexpr int band_rows = 32;
constexpr int most_repeats = 4;  // of the picture that a triangle is drawn in, along each side

/// A triangle in pixels, rows from the top.
struct PixelTriangle {
  glm::dvec2 a, b, c;
  double area = 0;  // twice, with a sign

  /// In the repeat of the picture that begins at `origin`.
  PixelTriangle(const UvCorners& uvs, glm::uvec3 corners, int size, glm::dvec2 origin) {
    const auto place = [&](std::uint32_t k) {
      const glm::dvec2 uv = glm::dvec2(uvs.corners[k].uv) - origin;
      return glm::dvec2(uv.x * size, (1 - uv.y) * size);
    };
    a = place(corners.x), b = place(corners.y), c = place(corners.z);
    area = cross(b - a, c - a);
  }
  static double cross(glm::dvec2 p, glm::dvec2 q) { return p.x * q.y - p.y * q.x; }
  glm::dvec3 barycentric(glm::dvec2 p) const {
    return glm::dvec3(cross(b - p, c - p), cross(c - p, a - p), cross(a - p, b - p)) / area;
  }
};

/// The repeats of the picture that a triangle lies in, by their first corners.
struct Repeats {
  glm::ivec2 first{0}, last{0};

  Repeats(const UvCorners& uvs, glm::uvec3 t) {
    const glm::vec2 a = uvs.corners[t.x].uv, b = uvs.corners[t.y].uv, c = uvs.corners[t.z].uv;
    first = glm::ivec2(glm::floor(glm::min(a, glm::min(b, c))));
    last = glm::max(glm::ivec2(glm::ceil(glm::max(a, glm::max(b, c)))) - 1, first);
    last = glm::min(last, first + most_repeats - 1);
  }
};

/// The first and the last pixel whose centre lies in [low, high]; none where first > last.
std::pair<int, int> centres_in(double low, double high, int first, int last) {
  return {static_cast<int>(std::clamp(std::ceil(low - 0.5), double(first), last + 1.0)),
          static_cast<int>(std::clamp(std::floor(high - 0.5), first - 1.0, double(last)))};
}

void put(MapImage& image, std::size_t pixel, glm::dvec4 value) {
  float* out = image.at(pixel);
  for (int k = 0; k < image.channels; ++k) out[k] = static_cast<float>(value[k]);
  image.covered[pixel] = 1;
}

/// The rows [top, bottom] of one triangle in one repeat of the picture.
void draw(const PixelTriangle& triangle, const std::array<glm::dvec4, 3>& values, int top, int bottom,
          MapImage& image) {
  const auto [low, high] = std::minmax({triangle.a.y, triangle.b.y, triangle.c.y});
  const auto [left, right] = std::minmax({triangle.a.x, triangle.b.x, triangle.c.x});
  if (triangle.area == 0) return;
  const auto [first_row, last_row] = centres_in(low, high, top, bottom);
  const auto [first, last] = centres_in(left, right, 0, image.size - 1);
  for (int y = first_row; y <= last_row; ++y) {
    for (int x = first; x <= last; ++x) {
      const glm::dvec3 weights = triangle.barycentric({x + 0.5, y + 0.5});
      if (!(weights.x >= 0 && weights.y >= 0 && weights.z >= 0)) continue;
      const std::size_t row = static_cast<std::size_t>(y) * static_cast<std::size_t>(image.size);
      const std::size_t pixel = row + static_cast<std::size_t>(x);
      put(image, pixel, weights.x * values[0] + weights.y * values[1] + weights.z * values[2]);
    }
  }
}

void draw_repeats(const UvCorners& uvs, glm::uvec3 corners, std::span<const glm::vec4> values, int top, int bottom,
                  MapImage& image) {
  const Repeats repeats(uvs, corners);
  const std::array<glm::dvec4, 3> own{glm::dvec4(values[corners.x]), glm::dvec4(values[corners.y]),
                                      glm::dvec4(values[corners.z])};
  for (int j = repeats.first.y; j <= repeats.last.y; ++j) {
    for (int i = repeats.first.x; i <= repeats.last.x; ++i)
      draw(PixelTriangle(uvs, corners, image.size, {i, j}), own, top, bottom, image);
  }
}

/// Corners of islands so thin or small that no pixel's centre lies in them.
void put_corners(const UvCorners& uvs, std::span<const glm::vec4> values, MapImage& image) {
  for (std::size_t k = 0; k < uvs.corners.size(); ++k) {
    const glm::dvec2 uv(wrapped(uvs.corners[k].uv.x), wrapped(uvs.corners[k].uv.y));
    const double last = image.size - 1.0;
    const auto x = static_cast<std::size_t>(std::min(uv.x * image.size, last));
    const auto y = static_cast<std::size_t>(std::clamp((1 - uv.y) * image.size, 0.0, last));
    const std::size_t pixel = y * static_cast<std::size_t>(image.size) + x;
    if (!image.covered[pixel]) put(image, pixel, glm::dvec4(values[k]));
  }
}

}  // namespace

MapImage make_map_image(int size, int channels, glm::dvec4 background) {
  const std::size_t pixels = static_cast<std::size_t>(size) * static_cast<std::size_t>(size);
  MapImage image{size, channels, std::vector<float>(pixels * static_cast<std::size_t>(channels)),
                 std::vector<std::uint8_t>(pixels, 0)};
  for (std::size_t i = 0; i < image.values.size(); ++i)
    image.values[i] = static_cast<float>(background[static_cast<int>(i % static_cast<std::size_t>(channels))]);
  return image;
}

// Bands of rows side by side, each with all triangles in their order, so that the last one wins everywhere.
void draw_triangles(const UvCorners& uvs, std::span<const glm::vec4> values, MapImage& image) {
  const auto bands = static_cast<std::uint32_t>((image.size + band_rows - 1) / band_rows);
  for_each_in_parallel(bands, [&](std::uint32_t band) {
    const int top = static_cast<int>(band) * band_rows, bottom = std::min(top + band_rows, image.size) - 1;
    for (const glm::uvec3 corners : uvs.of_triangle) draw_repeats(uvs, corners, values, top, bottom, image);
  });
  put_corners(uvs, values, image);
}

std::size_t count_outside(const UvCorners& uvs) {
  return static_cast<std::size_t>(std::count_if(uvs.of_triangle.begin(), uvs.of_triangle.end(), [&](glm::uvec3 t) {
    return !is_inside(uvs.corners[t.x].uv) || !is_inside(uvs.corners[t.y].uv) || !is_inside(uvs.corners[t.z].uv);
  }));
}

}  // namespace pelage
