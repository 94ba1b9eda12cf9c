// Blends segments of strands over a tile of the picture, front to back, by their coverage of each pixel.
#if defined(PELAGE_RASTER_BLEND_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef PELAGE_RASTER_BLEND_INL_H_
#undef PELAGE_RASTER_BLEND_INL_H_
#else
#define PELAGE_RASTER_BLEND_INL_H_
#endif

#include <hwy/cache_control.h>

#include <algorithm>
#include <bit>
#include <cmath>

#include "renderer/raster/kernels.h"
#include "renderer/raster/pixel_rays-inl.h"

HWY_BEFORE_NAMESPACE();
namespace pelage::HWY_NAMESPACE {

inline constexpr float min_half = 1;  // smallest half width, pixels: thinner strands are drawn this wide and fainter
/// All blocks of a tile: bit column * block_rows + row of a set stands for one block.
inline constexpr std::uint64_t all_blocks = ~std::uint64_t{0} >> (64 - block_columns * block_rows);

HWY_INLINE void load_light(const PlacedKnot& knot, float* light) {
  const hn::CappedTag<float, 4> four;
  const hn::Rebind<hwy::float16_t, decltype(four)> halves;
  hn::StoreU(hn::PromoteTo(four, hn::LoadU(halves, reinterpret_cast<const hwy::float16_t*>(knot.light.data()))), four,
             light);
}

/// A segment over a tile, in pixels from the tile's corner.
struct FlatSegment {
  float x, y, dir_x, dir_y;  // start, and unit direction
  float over_length, length;
  float half, more_half, inverse, more_inverse;  // half width and 1 / distance at the start; their increases to the end
  float sharpness;                               // 1 / width over which its ends fade, 1 / pixels
  float light[4], more_light[4];
};

HWY_INLINE FlatSegment flat_segment(const TileSegment& segment, float left, float top) {
  const PlacedKnot &a = *segment.from, &b = *segment.to;
  FlatSegment flat;
  const float across = b.x - a.x, down = b.y - a.y;
  flat.length = std::sqrt(std::max(across * across + down * down, 1e-8f)), flat.over_length = 1 / flat.length;
  flat.x = a.x - left, flat.y = a.y - top, flat.dir_x = across * flat.over_length, flat.dir_y = down * flat.over_length;
  flat.half = a.half_width, flat.more_half = b.half_width - a.half_width;
  flat.inverse = a.inverse, flat.more_inverse = b.inverse - a.inverse;
  flat.sharpness = std::clamp(8 * std::max(a.half_width, b.half_width) - 3, 1.0f, 8.0f);
  load_light(a, flat.light), load_light(b, flat.more_light);
  for (int i = 0; i < 4; ++i) flat.more_light[i] -= flat.light[i];
  return flat;
}

/// Returns the set of the tile's blocks that the segment may touch.
HWY_INLINE std::uint64_t touched_blocks(const TileSegment& segment, float left, float top) {
  const PlacedKnot &a = *segment.from, &b = *segment.to;
  const float wide = std::max({a.half_width, b.half_width, min_half}) + 0.6f;
  const float x0 = std::min(a.x, b.x) - left - wide, x1 = std::max(a.x, b.x) - left + wide;
  const float y0 = std::min(a.y, b.y) - top - wide, y1 = std::max(a.y, b.y) - top + wide;
  constexpr float side = tile_side;
  if (!(x1 > 0 && y1 > 0 && x0 < side && y0 < side)) return 0;
  const int first_x = static_cast<int>(std::max(x0, 0.0f)) / block_width;
  const int last_x = static_cast<int>(std::min(x1, side - 1)) / block_width;
  const int first_y = static_cast<int>(std::max(y0, 0.0f)) / block_height;
  const int last_y = static_cast<int>(std::min(y1, side - 1)) / block_height;
  const std::uint64_t rows = (std::uint64_t{2} << last_y) - (std::uint64_t{1} << first_y);
  std::uint64_t blocks = 0;
  for (int x = first_x; x <= last_x; ++x) blocks |= rows << (x * block_rows);
  return blocks;
}

/// Records a segment where it covers more of a pixel than any before: its number in red, the position along it in
/// green, its coverage in blue.
HWY_INLINE void note_largest(float number, Real share, Real weight, std::size_t at, TileSums& sums) {
  const Mask larger = weight > load(sums.blue + at);
  store(select(larger, number, load(sums.red + at)), sums.red + at);
  store(select(larger, share, load(sums.green + at)), sums.green + at);
  store(select(larger, weight, load(sums.blue + at)), sums.blue + at);
}

/// Adds a segment to an output that has no value at knots (has_knot_values). `weight` is its coverage times the
/// transmittance `transmittance` in front of it.
template <RasterOutput output>
HWY_INLINE void add_geometric_output(Real inverse, Real weight, Real transmittance, std::size_t at, TileSums& sums) {
  const Real before = load(sums.red + at);
  if constexpr (output == RasterOutput::distance) {
    store(mul_add(weight, 1.0f / max(inverse, 1e-12f), before), sums.red + at);
  } else if constexpr (output == RasterOutput::count) {
    store(before + select(weight > 0.0f, 1.0f, 0.0f), sums.red + at);
  } else {
    store(select((transmittance >= 0.5f) & (transmittance - weight < 0.5f), inverse, before), sums.red + at);
  }
}

/// Blends a segment over a block, a pixel a lane. Returns whether any pixel of it still lets light through.
template <RasterOutput output>
HWY_INLINE bool blend_lanes(const FlatSegment& s, float number, Real x, Real y, std::size_t at, TileSums& sums) {
  const Real along = mul_add(x, s.dir_x, y * s.dir_y), off = abs(y * s.dir_x - x * s.dir_y);
  const Real share = clamp(along * s.over_length, 0.0f, 1.0f);
  const Real half = mul_add(share, s.more_half, s.half), drawn = max(half, min_half);
  const Real covered = clamp(drawn - off + 0.5f, 0.0f, 1.0f) - clamp(0.5f - drawn - off, 0.0f, 1.0f);
  const Real within = clamp(mul_add(along, s.sharpness, 0.5f), 0.0f, 1.0f) -
                      clamp(mul_add(along - s.length, s.sharpness, 0.5f), 0.0f, 1.0f);
  static_assert(min_half == 1);  // so that half / drawn is min(half, 1):
  const Real alpha = min(covered * within * min(half, 1.0f), 1.0f);
  const Real transmittance = load(sums.transmittance + at);
  const Real inverse = mul_add(share, s.more_inverse, s.inverse);
  const Mask in_front = inverse > load(sums.background_inverse + at);
  const Real weight = select(in_front, alpha, 0.0f) * transmittance, left_over = transmittance - weight;
  store(left_over, sums.transmittance + at);
  if constexpr (output == RasterOutput::strand) {
    note_largest(number, share, weight, at, sums);
    return any(left_over > min_transmittance);
  }
  if constexpr (!has_knot_values(output)) {
    add_geometric_output<output>(inverse, weight, transmittance, at, sums);
    return any(left_over > min_transmittance);
  }
  const auto add = [&](int k, float* sum) HWY_ATTR {
    const Real sent = mul_add(share, s.more_light[k], s.light[k]);
    store(mul_add(weight, sent, load(sum + at)), sum + at);
  };
  add(0, sums.red), add(1, sums.green), add(2, sums.blue);
  return any(left_over > min_transmittance);
}

/// Blends all segments of a tile. `output` is albedo for every output that has values at knots.
template <RasterOutput output>
HWY_INLINE void blend_all(std::span<const TileSegment> segments, int left, int top, TileSums& sums) {
  const Vec2 first = block_pixels(0);
  const auto tile_left = static_cast<float>(left), tile_top = static_cast<float>(top);
  std::uint64_t full = 0;
  for (std::size_t i = 0; i < segments.size() && full != all_blocks; ++i) {
    if (i + 8 < segments.size()) hwy::Prefetch(segments[i + 8].from);
    std::uint64_t blocks = touched_blocks(segments[i], tile_left, tile_top) & ~full;
    if (blocks == 0) continue;
    const FlatSegment flat = flat_segment(segments[i], tile_left, tile_top);
    for (; blocks != 0; blocks &= blocks - 1) {
      const int block = std::countr_zero(blocks), bx = block / block_rows, by = block % block_rows;
      const Real x = first.x + (static_cast<float>(block_width * bx) - flat.x);
      const Real y = first.y + (static_cast<float>(block_height * by) - flat.y);
      if (!blend_lanes<output>(flat, static_cast<float>(i + 1), x, y, static_cast<std::size_t>(block * lane_count),
                               sums))
        full |= std::uint64_t{1} << block;
    }
  }
}

}  // namespace pelage::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
