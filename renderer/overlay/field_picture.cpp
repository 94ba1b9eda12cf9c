#include "renderer/overlay/field_picture.h"

#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>
#include <cstring>

#include "base/parallel.h"
#include "renderer/input/picture.h"
#include "renderer/upload/blocks.h"

namespace pelage {

namespace {

/// Makes an overlay of pixel(x, y), which returns sRGB with straight alpha.
template <class Pixel>
FloatImage plain_overlay(int width, int height, int threads, const Pixel& pixel) {
  auto image = empty_picture<FloatImage>(width, height);
  image.display_referred = true;
  const auto draw_row = [&](std::uint32_t y) {
    float* row = &image.rgba[4 * std::size_t{y} * static_cast<std::size_t>(width)];
    for (int x = 0; x < width; ++x) {
      const glm::vec4 colour = pixel(x, static_cast<int>(y));
      std::memcpy(row + std::ptrdiff_t{4} * x, &colour.x, sizeof colour);
    }
  };
  for_each_in_parallel(static_cast<std::uint32_t>(height), draw_row, threads);
  return image;
}

constexpr float overlay_strength = 0.6f;  // opacity of colours over the frame

float fraction(float x) { return x - std::floor(x); }

/// Returns the colour of a direction, sRGB: red to the right, then yellow, green up, blue to the left and violet down;
/// paler if it is shorter.
glm::vec3 hue_of(glm::vec2 direction) {
  const float length = std::min(glm::length(direction), 1.0f);
  const float turn = length > 1e-6f ? std::atan2(direction.y, direction.x) / 6.28318531f : 0.0f;
  const auto channel = [&](float offset) {
    return std::clamp(std::abs(fraction(turn + offset) * 6 - 3) - 1, 0.0f, 1.0f);
  };
  return glm::mix(glm::vec3(1), glm::vec3(channel(1), channel(0.66666667f), channel(0.33333333f)), length);
}

/// Returns the colour of a number in [0, 1], sRGB: dark violet for 0, then blue, green and yellow for 1. Lightness
/// rises evenly (viridis in five steps).
glm::vec3 ramp_of(float share) {
  constexpr std::array<glm::vec3, 5> steps{glm::vec3(0.267f, 0.005f, 0.329f), glm::vec3(0.230f, 0.322f, 0.546f),
                                           glm::vec3(0.128f, 0.567f, 0.551f), glm::vec3(0.369f, 0.789f, 0.383f),
                                           glm::vec3(0.993f, 0.906f, 0.144f)};
  const float at = std::clamp(share, 0.0f, 1.0f) * 4;
  const auto low = static_cast<std::size_t>(std::min(at, 3.0f));
  return glm::mix(steps[low], steps[low + 1], at - static_cast<float>(low));
}

/// Returns the lean of the fur at a vertex in the picture: to the right and up; length at most 1, for fur that lies
/// across the view.
glm::vec2 lean_on_picture(const FurFrame& frame, const glm::mat4& to_clip, const FieldVertex& vertex) {
  const glm::vec3 towards =
      vertex.tangent * vertex.direction.x + glm::cross(vertex.normal, vertex.tangent) * vertex.direction.y;
  const glm::vec4 at = to_clip * glm::vec4(vertex.position, 1), change = to_clip * glm::vec4(towards, 0);
  const float aspect = static_cast<float>(frame.width) / static_cast<float>(frame.height);
  const glm::vec2 moved =
      (glm::vec2(change) - glm::vec2(at) / std::max(at.w, near_distance) * change.w) * glm::vec2(aspect, 1);
  const float up = glm::length(glm::vec3(to_clip[0].y, to_clip[1].y, to_clip[2].y));
  const float across = glm::length(towards), shown = glm::length(moved) / up;
  if (!(across > 1e-6f) || !(shown > 1e-9f)) return glm::vec2(0);
  return moved / glm::length(moved) * std::min(shown, across);
}

glm::vec3 colour_of(Overlay overlay, glm::vec2 value) {
  if (overlay == Overlay::direction) return hue_of(value);
  if (overlay == Overlay::difference && !(value.x > 0)) return glm::vec3(0.5f);
  return ramp_of(value.x);
}

constexpr float cell = 10;  // side of a cell with one stroke, pixels

struct Stroke {
  bool there = false;
  glm::vec2 root{0}, along{0};  // pixels
};

/// One stroke in each cell of the picture that shows fur.
struct StrokeField {
  int across = 0, down = 0;  // cells
  std::vector<Stroke> strokes;

  Stroke at(glm::ivec2 of_cell) const {
    const bool inside = of_cell.x >= 0 && of_cell.y >= 0 && of_cell.x < across && of_cell.y < down;
    return inside ? strokes[static_cast<std::size_t>(of_cell.y * across + of_cell.x)] : Stroke{};
  }
};

/// Returns a small random offset of a cell's stroke, which hides the regular rows.
glm::vec2 moved(glm::ivec2 at) {
  const auto part = [](int number) { return fraction(std::sin(static_cast<float>(number) * 0.37f) * 43.758f) - 0.5f; };
  return 0.3f * glm::vec2(part(at.x * 127 + at.y * 311), part(at.x * 269 + at.y * 183));
}

/// `lean_at(x, y)`: lean at a pixel, to the right and up, and 1 where there is fur.
template <class LeanAt>
StrokeField stroke_field(int width, int height, const LeanAt& lean_at) {
  constexpr float longest = 1.6f * cell;
  const auto cells = [](int pixels) { return static_cast<int>(std::ceil(static_cast<float>(pixels) / cell)) + 1; };
  StrokeField field{cells(width), cells(height), {}};
  for (int y = 0; y < field.down; ++y) {
    for (int x = 0; x < field.across; ++x) {
      Stroke& stroke = field.strokes.emplace_back();
      stroke.root = (glm::vec2(x, y) + 0.5f + moved({x, y})) * cell;
      if (stroke.root.x >= static_cast<float>(width) || stroke.root.y >= static_cast<float>(height)) continue;
      const glm::vec3 fur = lean_at(static_cast<int>(stroke.root.x), static_cast<int>(stroke.root.y));
      const glm::vec2 lean(fur.x, -fur.y);
      stroke.there = fur.z > 0.5f;
      stroke.along = lean / std::sqrt(std::max(glm::length(lean), 1e-4f)) * longest;
    }
  }
  return field;
}

/// Returns the distance of a pixel's centre to a stroke's edge, pixels.
float distance_to(const Stroke& stroke, glm::vec2 pixel) {
  constexpr float root_width = 0.8f, tip_width = 0.2f, nowhere = 1e3f;  // half widths
  if (!stroke.there) return nowhere;
  const glm::vec2 apart = pixel - stroke.root;
  const float square = std::max(glm::dot(stroke.along, stroke.along), 1e-6f);
  const float share = std::clamp(glm::dot(apart, stroke.along) / square, 0.0f, 1.0f);
  return glm::length(apart - share * stroke.along) - glm::mix(root_width, tip_width, share);
}

/// Returns the colour of a pixel with short lines along the fur: one in each cell, thick at the root and thin at the
/// tip; longer where the fur leans more, and a dot where it stands upright or points at the camera.
glm::vec4 stroke_at(const StrokeField& field, int x, int y) {
  constexpr float silhouette = 0.9f;  // pixels
  const glm::vec2 pixel(static_cast<float>(x) + 0.5f, static_cast<float>(y) + 0.5f);
  const glm::ivec2 middle(glm::floor(pixel / cell));
  float nearest = 1e3f;
  for (int k = 0; k < 25; ++k)
    nearest = std::min(nearest, distance_to(field.at(middle + glm::ivec2(k % 5 - 2, k / 5 - 2)), pixel));
  const float core = std::clamp(0.5f - nearest, 0.0f, 1.0f),
              whole = std::clamp(0.5f + silhouette - nearest, 0.0f, 1.0f);
  return {glm::vec3(core), std::max(core, 0.6f * whole)};
}

}  // namespace

bool is_field(Overlay overlay) {
  switch (overlay) {
    case Overlay::direction:
    case Overlay::strokes:
    case Overlay::length:
    case Overlay::density:
    case Overlay::wetness:
    case Overlay::mask:
    case Overlay::difference: return true;
    default: return false;
  }
}

FieldValues::FieldValues(const FurFrame& frame, float longest)
    : frame_(frame), to_clip_(world_to_clip(frame)), longest_(std::max(longest, 1e-9f)) {
  assert(is_field(frame.overlay));
}

glm::vec3 FieldValues::of(const FieldVertex& vertex) const {
  const bool shown = frame_.overlay != Overlay::strokes || vertex.length > 0;  // strokes need fur
  return {number_of(vertex), shown ? 1.0f : 0.0f};
}

glm::vec2 FieldValues::number_of(const FieldVertex& vertex) const {
  switch (frame_.overlay) {
    case Overlay::length: return {vertex.length / longest_, 0};
    case Overlay::density: return {vertex.density, 0};
    case Overlay::wetness: return {vertex.wetness, 0};
    case Overlay::mask: return {vertex.mask, 0};
    case Overlay::difference: return {frame_.difference[vertex.model_vertex], 0};
    default: return lean_on_picture(frame_, to_clip_, vertex);
  }
}

FloatImage field_picture(const FurFrame& frame, const std::vector<glm::vec3>& seen, int threads) {
  const auto at = [&](int x, int y) {
    return seen[static_cast<std::size_t>(y) * static_cast<std::size_t>(frame.width) + static_cast<std::size_t>(x)];
  };
  if (frame.overlay != Overlay::strokes) {
    return plain_overlay(frame.width, frame.height, threads, [&](int x, int y) {
      const glm::vec3 value = at(x, y);
      if (value.z == 0) return glm::vec4(0);
      return glm::vec4(colour_of(frame.overlay, glm::vec2(value)), overlay_strength * value.z);
    });
  }
  const StrokeField field = stroke_field(frame.width, frame.height, at);
  return plain_overlay(frame.width, frame.height, threads, [&](int x, int y) { return stroke_at(field, x, y); });
}

namespace {

// sRGB
constexpr float behind = 0.24f, darkest = 0.34f, lightest = 0.86f;
constexpr glm::vec3 edge_colour(0.08f, 0.18f, 0.32f);

struct Shape {
  const FurFrame& frame;
  const FurModel& model;
  const FloatImage &normals, &triangle_ids;

  static std::size_t index(const FloatImage& image, int x, int y) {
    return 4 * (static_cast<std::size_t>(y) * static_cast<std::size_t>(image.width) + static_cast<std::size_t>(x));
  }
  bool there(int x, int y) const { return normals.rgba[index(normals, x, y) + 3] > 0; }

  /// Returns the grey of a pixel, sRGB: brightest where the skin is perpendicular to the view, `behind` without skin.
  float grey_at(int x, int y) const {
    if (!there(x, y)) return behind;
    const float* normal = &normals.rgba[index(normals, x, y)];
    const FurCamera& camera = frame.camera;
    const float over = 2 * camera.tan_half_fov / static_cast<float>(frame.height);
    const glm::vec2 off = (glm::vec2(x, y) + 0.5f - 0.5f * glm::vec2(frame.width, frame.height)) * over;
    const glm::vec3 view_direction = camera.forward + off.x * camera.right - off.y * camera.up;
    const float facing = std::abs(glm::dot(glm::vec3(normal[0], normal[1], normal[2]), glm::normalize(view_direction)));
    return glm::mix(darkest, lightest, std::min(facing, 1.0f));
  }

  /// Returns the vertices of the triangle at a pixel in ascending order: triangles of the skin overlap, and several
  /// have the same vertices.
  std::array<std::uint32_t, 3> corners_at(int x, int y) const {
    const glm::uvec3 t = model.triangles[static_cast<std::size_t>(triangle_ids.rgba[index(triangle_ids, x, y)])];
    std::array<std::uint32_t, 3> corners{t.x, t.y, t.z};
    std::sort(corners.begin(), corners.end());
    return corners;
  }

  /// Returns true if the pixel to the right or below shows another triangle.
  bool is_edge(int x, int y) const {
    const auto differs = [&](int beside_x, int beside_y) {
      if (beside_x >= frame.width || beside_y >= frame.height) return false;
      const bool here = there(x, y), beside = there(beside_x, beside_y);
      return here != beside || (here && corners_at(x, y) != corners_at(beside_x, beside_y));
    };
    return differs(x + 1, y) || differs(x, y + 1);
  }
};

}  // namespace

FloatImage shape_picture(const FurFrame& frame, const FurModel& model, const FloatImage& normals,
                         const FloatImage& triangle_ids, int threads) {
  assert(normals.width == frame.width && triangle_ids.width == frame.width);
  const Shape shape{frame, model, normals, triangle_ids};
  return plain_overlay(frame.width, frame.height, threads, [&](int x, int y) {
    const glm::vec3 grey(shape.grey_at(x, y));
    const bool edge = frame.overlay == Overlay::wire && shape.is_edge(x, y);
    return glm::vec4(edge ? glm::mix(grey, edge_colour, 0.7f) : grey, 1);
  });
}

}  // namespace pelage
