#include "renderer/raster/skin.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <span>
#include <utility>
#include <vector>

#include "base/parallel.h"
#include "renderer/raster/kernels.h"

namespace pelage {

namespace {

/// A triangle projected to the picture. In double precision, because corners of near triangles lie millions of pixels
/// away.
struct FlatTriangle {
  std::array<glm::dvec2, 3> at{};
  glm::dvec3 inverse{0};
  std::uint32_t triangle = 0;
};

glm::dvec3 in_camera(const PictureCamera& camera, glm::vec3 position) {
  const glm::dvec3 apart(position - camera.position);
  return {glm::dot(apart, glm::dvec3(camera.right)), glm::dot(apart, glm::dvec3(camera.up)),
          glm::dot(apart, glm::dvec3(camera.forward))};
}

/// A position on the picture, pixels, and 1 / its distance.
struct FlatCorner {
  glm::dvec2 at{0};
  double inverse = 0;  // 0 if too near to be drawn
};

FlatCorner flat(const PictureCamera& camera, const glm::dvec3& corner) {
  if (corner.z < double{near_distance}) return {};
  const double inverse = 1 / corner.z, scale = inverse * double{camera.scale};
  return {{camera.middle.x + corner.x * scale, camera.middle.y - corner.y * scale}, inverse};
}

FlatTriangle triangle_of(const FlatCorner& a, const FlatCorner& b, const FlatCorner& c, std::uint32_t triangle) {
  return {{a.at, b.at, c.at}, {a.inverse, b.inverse, c.inverse}, triangle};
}

/// Clips a triangle at near_distance (Sutherland and Hodgman 1974). Returns the number of triangles left: up to two.
std::size_t clipped(const PictureCamera& camera, const std::array<glm::dvec3, 3>& corners, std::uint32_t triangle,
                    std::array<FlatTriangle, 2>& triangles) {
  constexpr double min_depth = near_distance;
  std::array<glm::dvec3, 4> fan;
  std::size_t count = 0;
  for (std::size_t i = 0; i < 3; ++i) {
    const glm::dvec3 &a = corners[i], &b = corners[(i + 1) % 3];
    if (a.z >= min_depth) fan[count++] = a;
    if ((a.z >= min_depth) != (b.z >= min_depth)) {
      fan[count] = a + (b - a) * ((min_depth - a.z) / (b.z - a.z));
      fan[count++].z = min_depth;
    }
  }
  for (std::size_t i = 2; i < count; ++i)
    triangles[i - 2] = triangle_of(flat(camera, fan[0]), flat(camera, fan[i - 1]), flat(camera, fan[i]), triangle);
  return count < 3 ? 0 : count - 2;
}

/// Returns whether a triangle may contain the middle of a pixel of the box. Few triangles of a fine mesh do.
bool meets_pixel(const FlatTriangle& triangle, const PixelBox& box) {
  constexpr double beside = 0.5 - 2e-3;  // half a pixel, reduced by twice the overlap of covered_pixels
  const auto [x0, x1] = std::minmax({triangle.at[0].x, triangle.at[1].x, triangle.at[2].x});
  const auto [y0, y1] = std::minmax({triangle.at[0].y, triangle.at[1].y, triangle.at[2].y});
  if (!(x1 > box.left && x0 < box.right && y1 > box.top && y0 < box.bottom)) return false;
  return std::floor(x1 - beside) >= std::ceil(x0 - 1 + beside) && std::floor(y1 - beside) >= std::ceil(y0 - 1 + beside);
}

constexpr std::uint32_t batch_size = 8192;  // vertices or triangles of a task; the same for any number of threads

/// Calls each(batch, i) for all i below `count`, in batches.
template <class Each>
void in_batches(std::size_t count, int threads, const Each& each) {
  const auto end = static_cast<std::uint32_t>(count);
  for_each_in_parallel((end + batch_size - 1) / batch_size,
                       [&](std::uint32_t batch) {
                         for (std::uint32_t i = batch * batch_size; i < std::min((batch + 1) * batch_size, end); ++i)
                           each(batch, i);
                       },
                       threads);
}

/// Returns the projected triangles of the model, in their order, in batches. Culls those that contain no pixel's
/// middle.
std::vector<std::vector<FlatTriangle>> flat_triangles(const RasterScene& scene, const PixelBox& box, int threads) {
  const FurModel& model = *scene.model;
  const auto in_view = [&](std::uint32_t v) { return in_camera(scene.camera, model.positions[v]); };
  std::vector<FlatCorner> corners(model.positions.size());
  in_batches(corners.size(), threads,
             [&](std::uint32_t, std::uint32_t v) { corners[v] = flat(scene.camera, in_view(v)); });
  std::vector<std::vector<FlatTriangle>> batches((model.triangles.size() + batch_size - 1) / batch_size);
  in_batches(model.triangles.size(), threads, [&](std::uint32_t batch, std::uint32_t i) {
    const glm::uvec3 t = model.triangles[i];
    const FlatCorner &a = corners[t.x], &b = corners[t.y], &c = corners[t.z];
    std::array<FlatTriangle, 2> found{triangle_of(a, b, c, i), {}};
    const bool unclipped = a.inverse > 0 && b.inverse > 0 && c.inverse > 0;
    const std::size_t count =
        unclipped ? 1 : clipped(scene.camera, {in_view(t.x), in_view(t.y), in_view(t.z)}, i, found);
    for (std::size_t k = 0; k < count; ++k)
      if (meets_pixel(found[k], box)) batches[batch].push_back(found[k]);
  });
  return batches;
}

/// Calls found(tile) for each tile that a triangle's bounding box touches.
template <class Found>
void each_tile(const FlatTriangle& triangle, const PixelBox& box, const TileRows& tiles, const Found& found) {
  const auto [x0, x1] = std::minmax({triangle.at[0].x, triangle.at[1].x, triangle.at[2].x});
  const auto [y0, y1] = std::minmax({triangle.at[0].y, triangle.at[1].y, triangle.at[2].y});
  const auto tile = [](double pixel, int first, int count) {
    return static_cast<int>(std::clamp((pixel - first) / tile_side, 0.0, static_cast<double>(count - 1)));
  };
  for (int y = tile(y0, box.top, tiles.down); y <= tile(y1, box.top, tiles.down); ++y) {
    for (int x = tile(x0, box.left, tiles.across); x <= tile(x1, box.left, tiles.across); ++x)
      found(y * tiles.across + x);
  }
}

/// A value that is linear over the picture: at the middle of a tile's first pixel, and its steps from pixel to pixel.
struct Plane {
  float at = 0, across = 0, down = 0;
};

/// Barycentrics of a triangle and 1 / distance, relative to a tile's corner, where floats are precise enough.
struct TilePlanes {
  std::array<Plane, 3> share;
  Plane inverse;
  bool there = false;  // the triangle is not degenerate
};

TilePlanes planes_over(const FlatTriangle& t, int left, int top) {
  const glm::dvec2 ab = t.at[1] - t.at[0], ac = t.at[2] - t.at[0];
  const double area = ab.x * ac.y - ab.y * ac.x;
  TilePlanes planes;
  if (!(std::abs(area) > 1e-12)) return planes;
  planes.there = true;
  const glm::dvec2 first(left + 0.5, top + 0.5);
  glm::dvec3 at(0), across(0), down(0);
  for (int i = 0; i < 3; ++i) {
    const glm::dvec2 &a = t.at[static_cast<std::size_t>((i + 1) % 3)], &b = t.at[static_cast<std::size_t>((i + 2) % 3)];
    const glm::dvec2 edge = (b - a) / area, off = first - a;
    at[i] = edge.x * off.y - edge.y * off.x, across[i] = -edge.y, down[i] = edge.x;
    planes.share[static_cast<std::size_t>(i)] = {static_cast<float>(at[i]), static_cast<float>(across[i]),
                                                 static_cast<float>(down[i])};
  }
  planes.inverse = {static_cast<float>(glm::dot(at, t.inverse)), static_cast<float>(glm::dot(across, t.inverse)),
                    static_cast<float>(glm::dot(down, t.inverse))};
  return planes;
}

/// Returns the pixels [first, end) of a row in which all three barycentrics are at least 0. Neighbouring triangles
/// overlap a little, so that no pixel is missed between them.
std::pair<int, int> covered_pixels(const TilePlanes& planes, int y, int first, int end) {
  constexpr float overlap = 1e-3f;  // pixels
  float low = static_cast<float>(first), high = static_cast<float>(end - 1);
  for (const Plane& share : planes.share) {
    const float at = share.at + share.down * static_cast<float>(y);
    if (share.across > 0) low = std::max(low, -at / share.across);
    if (share.across < 0) high = std::min(high, -at / share.across);
    if (share.across == 0 && at < 0) return {0, 0};
  }
  if (!(low <= high + overlap)) return {0, 0};
  return {std::max(static_cast<int>(std::ceil(low - overlap)), first),
          std::min(static_cast<int>(std::floor(high + overlap)) + 1, end)};
}

void raster_triangle(const FlatTriangle& t, int left, int top, float* inverse, std::uint32_t* triangle) {
  const TilePlanes planes = planes_over(t, left, top);
  if (!planes.there) return;
  const auto [x0, x1] = std::minmax({t.at[0].x, t.at[1].x, t.at[2].x});
  const auto [y0, y1] = std::minmax({t.at[0].y, t.at[1].y, t.at[2].y});
  const auto pixel = [](double at, int first) {
    return static_cast<int>(std::clamp(std::floor(at - first), 0.0, tile_side - 1.0));
  };
  const int begin_x = pixel(x0, left), end_x = pixel(x1, left) + 1;
  for (int y = pixel(y0, top); y <= pixel(y1, top); ++y) {
    const auto [first, end] = covered_pixels(planes, y, begin_x, end_x);
    float found = planes.inverse.at + planes.inverse.down * static_cast<float>(y) +
                  planes.inverse.across * static_cast<float>(first);
    for (int x = first; x < end; ++x, found += planes.inverse.across) {
      const auto at = static_cast<std::size_t>(pixel_in_tile(x, y));
      if (found > inverse[at]) inverse[at] = found, triangle[at] = t.triangle;
    }
  }
}

/// Triangles grouped by tile: those of tile t are order[first[t]] up to, not including, order[first[t + 1]].
struct TileTriangles {
  std::vector<std::uint32_t> first;
  std::vector<const FlatTriangle*> order;
};

TileTriangles by_tile(std::span<const std::vector<FlatTriangle>> batches, const PixelBox& box, const TileRows& tiles) {
  const auto each = [&](const auto& found) {
    for (const std::vector<FlatTriangle>& batch : batches)
      for (const FlatTriangle& triangle : batch)
        each_tile(triangle, box, tiles, [&](int tile) { found(static_cast<std::size_t>(tile), triangle); });
  };
  TileTriangles by;
  by.first.resize(static_cast<std::size_t>(tiles.count()) + 1);
  each([&](std::size_t tile, const FlatTriangle&) { ++by.first[tile + 1]; });
  for (std::size_t i = 0; i + 1 < by.first.size(); ++i) by.first[i + 1] += by.first[i];
  by.order.resize(by.first.back());
  std::vector<std::uint32_t> next(by.first.begin(), by.first.end() - 1);
  each([&](std::size_t tile, const FlatTriangle& triangle) { by.order[next[tile]++] = &triangle; });
  return by;
}

/// Returns 1 / the furthest distance in a block of a tile's pixels.
float furthest_of_block(const float* inverse, int left, int top) {
  float furthest = std::numeric_limits<float>::max();
  for (int y = top; y < top + hiding_side; ++y)
    for (int x = left; x < left + hiding_side; ++x) furthest = std::min(furthest, inverse[pixel_in_tile(x, y)]);
  return furthest;
}

}  // namespace

float* SkinPixels::add_eyes(const RasterScene& scene, std::uint32_t tile, int left, int top) {
  const std::size_t first = std::size_t{tile} * tile_pixels;
  const std::span<float> background_inverse = std::span(with_eyes_).subspan(first, tile_pixels);
  std::copy_n(&inverse[first], tile_pixels, background_inverse.begin());
  intersect_eyes(scene, left, top, background_inverse, std::span(eyes).subspan(first, tile_pixels));
  return background_inverse.data();
}

/// Takes the minimum along rows, then along columns.
void SkinPixels::dilate_hidden(int across, int down) {
  constexpr int blocks_around = hiding_radius / hiding_side;
  const auto spread_row = [](const float* from, std::ptrdiff_t step, int count, float* to) {
    for (int i = 0; i < count; ++i) {
      float around = i < blocks_around || i + blocks_around >= count ? 0.0f : std::numeric_limits<float>::max();
      for (int k = std::max(i - blocks_around, 0); k <= std::min(i + blocks_around, count - 1); ++k)
        around = std::min(around, from[k * step]);
      to[i * step] = around;
    }
  };
  std::vector<float> along(hidden.size());
  for (int y = 0; y < down; ++y)
    spread_row(&hidden[static_cast<std::size_t>(y * across)], 1, across, &along[static_cast<std::size_t>(y * across)]);
  for (int x = 0; x < across; ++x)
    spread_row(&along[static_cast<std::size_t>(x)], across, down, &hidden[static_cast<std::size_t>(x)]);
}

SkinPixels::SkinPixels(const RasterScene& scene, const PixelBox& box, int threads) {
  constexpr int blocks = tile_side / hiding_side;
  const TileRows tiles = tiles_of(box);
  const auto count = static_cast<std::size_t>(tiles.count());
  inverse.assign(count * tile_pixels, 0), triangle.assign(count * tile_pixels, 0);
  furthest.assign(count, 0), hidden.assign(count * blocks * blocks, 0);
  if (!scene.eyes.empty()) eyes.assign(count * tile_pixels, -1), with_eyes_.resize(count * tile_pixels);
  const std::vector<std::vector<FlatTriangle>> triangles = flat_triangles(scene, box, threads);
  const TileTriangles by = by_tile(triangles, box, tiles);
  const auto raster_tile = [&](std::uint32_t tile) {
    const int x = static_cast<int>(tile) % tiles.across, y = static_cast<int>(tile) / tiles.across;
    const int left = box.left + x * tile_side, top = box.top + y * tile_side;
    float* at = &inverse[std::size_t{tile} * tile_pixels];
    std::uint32_t* tile_triangles = &triangle[std::size_t{tile} * tile_pixels];
    for (std::uint32_t i = by.first[tile]; i < by.first[tile + 1]; ++i)
      raster_triangle(*by.order[i], left, top, at, tile_triangles);
    if (!eyes.empty()) at = add_eyes(scene, tile, left, top);
    const bool drawn = !scene.drawn || scene.drawn->has(left, top);
    furthest[tile] = drawn ? *std::min_element(at, at + tile_pixels) : std::numeric_limits<float>::max();
    for (int k = 0; k < blocks * blocks; ++k) {
      const int bx = k % blocks, by_row = k / blocks;
      const int block = ((y * blocks + by_row) * tiles.across + x) * blocks + bx;
      hidden[static_cast<std::size_t>(block)] = furthest_of_block(at, bx * hiding_side, by_row * hiding_side);
    }
  };
  for_each_in_parallel(static_cast<std::uint32_t>(count), raster_tile, threads);
  dilate_hidden(tiles.across * blocks, tiles.down * blocks);
}

}  // namespace pelage
