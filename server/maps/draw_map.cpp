#include "server/maps/draw_map.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>

#include "base/clamped_index.h"
#include "base/parallel.h"
#include "server/maps/encoding.h"
#include "server/maps/read_map.h"

namespace pelage {

namespace {

bool is_float(MapFormat format) { return format != MapFormat::png && format != MapFormat::png16; }

double largest(const FieldSet& fields, Field field) {
  if (fields.at_default(field)) return shape_of(field).default_value;
  const std::vector<float>& values = fields.values(field);
  return *std::max_element(values.begin(), values.end());
}

/// Returns the field to which the scale applies.
Field scaled_field(Field field, MapEncoding encoding) {
  if (encoding == MapEncoding::fast_fur) return Field::width;
  return encoding == MapEncoding::vector ? Field::length : field;
}

bool is_length(Field field) { return field == Field::length; }

/// Returns the requested scale, or else the one that uses the whole range of a PNG (1 for floats). It is in the field's
/// unit, lengths in sizes.
double scale_of(const Mesh& mesh, const FieldSet& fields, const MapRequest& request, MapEncoding encoding) {
  const Field scaled = scaled_field(request.field, encoding);
  const bool world = is_length(scaled) && request.units == Units::world;
  if (request.scale) return world ? *request.scale / mesh.size : *request.scale;
  const bool is_open =
      scaled == Field::length || scaled == Field::stretch || scaled == Field::width || scaled == Field::stiffness;
  if (is_float(request.format)) return world ? 1 / mesh.size : 1;
  if (!is_open) return 1;
  const double max = largest(fields, scaled);
  return max > 0 ? max : 1;
}

/// Returns a corner's value in the map; colours are premultiplied.
glm::dvec4 value_at(const UvCorner& corner, const FieldSet& fields, Field field, MapEncoding encoding, double scale) {
  const glm::dvec4 value(fields.value(field, corner.vertex));
  if (encoding == MapEncoding::value) {
    if (shape_of(field).channels == 4) return glm::dvec4(glm::dvec3(value) * value.w, value.w);
    return value / scale;
  }
  const glm::dvec2 direction = corner.to_uv(glm::dvec2(value));
  if (encoding == MapEncoding::uv_tangent) return glm::dvec4(direction, 0, 0);
  if (encoding == MapEncoding::fast_fur) {
    return glm::dvec4(direction, fields.number(Field::width, corner.vertex) / scale,
                      fields.number(Field::density, corner.vertex));
  }
  const double upright = std::sqrt(std::max(1 - glm::dot(direction, direction), 0.0));
  return glm::dvec4(direction, upright, 0) * (double{fields.number(Field::length, corner.vertex)} / scale);
}

void divide_by_cover(MapImage& image) {
  for (std::size_t i = 0; i < image.values.size(); i += 4) {
    const float cover = image.values[i + 3];
    for (std::size_t k = 0; k < 3; ++k) image.values[i + k] = cover > 0 ? image.values[i + k] / cover : 0.0f;
  }
}

double covered_share(const MapImage& image) {
  const auto count = std::count(image.covered.begin(), image.covered.end(), std::uint8_t{1});
  return static_cast<double>(count) / static_cast<double>(image.covered.size());
}

MapAnswer answer_of(const Mesh& mesh, const MapRequest& request, MapEncoding encoding, double scale, double covered) {
  MapAnswer answer{.field = request.field, .encoding = encoding, .units = request.units, .covered = covered};
  const bool world = is_length(scaled_field(request.field, encoding)) && request.units == Units::world;
  answer.scale = world ? scale * mesh.size : scale;
  return answer;
}

}  // namespace

VertexList list_vertices(const Mesh& mesh, const FieldSet& fields, const MapRequest& request) {
  const double scale = scale_of(mesh, fields, request, MapEncoding::vertices);
  const int channels = request.field == Field::direction ? 3 : shape_of(request.field).channels;
  VertexList list{static_cast<std::size_t>(channels), {}, answer_of(mesh, request, MapEncoding::vertices, scale, 1)};
  list.values.reserve(list.channels * mesh.positions.size());
  for (std::uint32_t v = 0; v < mesh.positions.size(); ++v) {
    glm::dvec4 value(fields.value(request.field, v));
    if (request.field == Field::direction) {
      const glm::dvec3 x(mesh.tangents[v]), y = glm::cross(glm::dvec3(mesh.normals[v]), x);
      value = glm::dvec4(x * value.x + y * value.y, 0);
    } else if (channels == 1) {
      value /= scale;
    }
    for (int k = 0; k < channels; ++k) list.values.push_back(static_cast<float>(value[k]));
  }
  return list;
}

DrawnMap draw_map(const Mesh& mesh, const FieldSet& fields, const MapRequest& request) {
  const MapEncoding encoding = encoding_of(request.field, request.encoding);
  const double scale = scale_of(mesh, fields, request, encoding);
  const UvCorners all = make_uv_corners(mesh), uvs = in_udim(all, request.tile);
  std::vector<glm::vec4> values;
  values.reserve(uvs.corners.size());
  for (const UvCorner& corner : uvs.corners)
    values.emplace_back(value_at(corner, fields, request.field, encoding, scale));

  DrawnMap map;
  map.layout = layout_of(request.field, encoding, scale, is_float(request.format));
  map.image = make_map_image(request.size, map.layout.channels, map.layout.background);
  draw_triangles(uvs, values, map.image);
  const double covered = covered_share(map.image);
  dilate(map.image, request.dilate);
  fit_corners(uvs, values, map.layout.min, map.layout.max, map.image);
  if (map.layout.premultiplied && !is_float(request.format)) divide_by_cover(map.image);
  map.answer = answer_of(mesh, request, encoding, scale, covered);
  map.answer.outside = count_outside(uvs), map.answer.tiles = udims_of(all);
  return map;
}

namespace {

constexpr int band_rows = 32;
constexpr int max_repeats = 4;  // repeats of the picture in which a triangle is drawn, along each side

/// A triangle in pixels, rows from the top.
struct PixelTriangle {
  glm::dvec2 a, b, c;
  double area = 0;  // twice the signed area

  /// Makes the triangle in the repeat of the picture that begins at `origin`.
  PixelTriangle(const UvCorners& uvs, glm::uvec3 corners, int size, glm::dvec2 origin) {
    const auto to_pixels = [&](std::uint32_t k) {
      const glm::dvec2 uv = glm::dvec2(uvs.corners[k].uv) - origin;
      return glm::dvec2(uv.x * size, (1 - uv.y) * size);
    };
    a = to_pixels(corners.x), b = to_pixels(corners.y), c = to_pixels(corners.z);
    area = cross(b - a, c - a);
  }
  static double cross(glm::dvec2 p, glm::dvec2 q) { return p.x * q.y - p.y * q.x; }
  glm::dvec3 barycentric(glm::dvec2 p) const {
    return glm::dvec3(cross(b - p, c - p), cross(c - p, a - p), cross(a - p, b - p)) / area;
  }
};

/// The range of repeats of the picture in which a triangle lies, by their lower corners.
struct Repeats {
  glm::ivec2 first{0}, last{0};

  Repeats(const UvCorners& uvs, glm::uvec3 t) {
    const glm::vec2 a = uvs.corners[t.x].uv, b = uvs.corners[t.y].uv, c = uvs.corners[t.z].uv;
    const glm::vec2 low = glm::min(a, glm::min(b, c)), high = glm::max(a, glm::max(b, c));
    constexpr int farthest = 1 << 24;  // beyond it 32-bit floats have no fraction, so no position in a picture
    for (int k = 0; k < 2; ++k) {
      first[k] = clamped_index(std::floor(low[k]), -farthest, farthest);
      last[k] = std::max(clamped_index(std::ceil(high[k]), -farthest, farthest) - 1, first[k]);
    }
    last = glm::min(last, first + max_repeats - 1);
  }
};

/// Returns the first and the last pixel whose centre lies in [low, high]; none if the first is larger.
std::pair<int, int> centres_in(double low, double high, int first, int last) {
  return {static_cast<int>(std::clamp(std::ceil(low - 0.5), double(first), last + 1.0)),
          static_cast<int>(std::clamp(std::floor(high - 0.5), first - 1.0, double(last)))};
}

void put(MapImage& image, std::size_t pixel, glm::dvec4 value) {
  float* out = image.at(pixel);
  for (int k = 0; k < image.channels; ++k) out[k] = static_cast<float>(value[k]);
  image.covered[pixel] = 1;
}

/// Draws the rows [top, bottom] of one triangle in one repeat of the picture.
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

/// Puts the corners of islands that are so thin or small that no pixel's centre lies in them.
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

// Draws bands of rows in parallel, each with all triangles in their order, so that the last one wins everywhere.
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

namespace {

constexpr std::int8_t none = 127;  // larger than any requested distance

/// Writes for each pixel of a row the offset to its nearest covered pixel in that row, positive to the right; `none`
/// beyond the distance.
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

// Finds the nearest pixel along each row first, then over the rows: Felzenszwalb and Huttenlocher's two passes, limited
// to the distance.
void dilate(MapImage& image, int distance) {
  if (distance <= 0) return;
  const auto size = static_cast<std::size_t>(image.size);
  std::vector<std::int8_t> steps(size * size);
  std::vector<std::uint8_t> grown = image.covered;
  const auto rows = static_cast<std::uint32_t>(image.size);
  for_each_in_parallel(
      rows, [&](std::uint32_t y) { find_in_row(&image.covered[y * size], image.size, distance, &steps[y * size]); });
  const auto fill = [&](int x, int y) {
    const std::size_t here = static_cast<std::size_t>(y) * size + static_cast<std::size_t>(x);
    int nearest = distance * distance + 1;
    std::size_t source = here;
    const auto look = [&](int row) {
      if (row < 0 || row >= image.size) return;
      const std::size_t there = static_cast<std::size_t>(row) * size + static_cast<std::size_t>(x);
      const auto step = int{steps[there]};
      const int far = step * step + (row - y) * (row - y);
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
