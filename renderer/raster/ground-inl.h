// The ground behind a model: how much darker the light that is missing makes it.
#if defined(PELAGE_RASTER_GROUND_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef PELAGE_RASTER_GROUND_INL_H_
#undef PELAGE_RASTER_GROUND_INL_H_
#else
#define PELAGE_RASTER_GROUND_INL_H_
#endif

#include <algorithm>
#include <cmath>

#include "renderer/raster/kernels.h"
#include "renderer/raster/pixel_rays-inl.h"
#include "renderer/raster/strand_light-inl.h"

HWY_BEFORE_NAMESPACE();
namespace pelage::HWY_NAMESPACE {

inline constexpr float ground_whole = 1, ground_end = 3.5f;  // from the middle, sizes: between them it fades

/// Of the map, between its four nearest places.
HWY_INLINE Real sky_hidden(const SkyOverGround& sky, Vec3 place) {
  if (sky.hidden.empty()) return 0.0f;
  const Real x = (place.x - sky.low.x) * (1 / sky.cell), y = (place.z - sky.low.y) * (1 / sky.cell);
  const auto width = static_cast<float>(sky.size.x), height = static_cast<float>(sky.size.y);
  const Real left = clamp(floor(x), 0.0f, width - 2), top = clamp(floor(y), 0.0f, height - 2);
  const Real across = clamp(x - left, 0.0f, 1.0f), down = clamp(y - top, 0.0f, 1.0f);
  const Int at = to_int(mul_add(top, width, left));
  const float* first = sky.hidden.data();
  const Real above = mix(gather(first, at), gather(first + 1, at), across);
  const Real below = mix(gather(first + sky.size.x, at), gather(first + sky.size.x + 1, at), across);
  const Mask inside = (x >= 0.0f) & (y >= 0.0f) & (x <= width - 1) & (y <= height - 1);
  return select(inside, mix(above, below, down), 0.0f);
}

/// Where the way from a place to a light comes into the grid, if it does: what it crosses is known there.
struct GridEntry {
  Vec3 place;
  Mask there;
};

HWY_INLINE GridEntry grid_entry(const GridPlace& grid, Vec3 from, Vec3 way) {
  const glm::vec3 low = grid.low, high = low + grid.cell * glm::vec3(grid.size);
  Real begin = 0.0f, end = 1e9f;
  const auto pass = [&](Real at, Real step, float a, float b) HWY_ATTR {
    const Real over = 1.0f / select(abs(step) > 1e-6f, step, 1e-6f);
    const Real first = (Real(a) - at) * over, last = (Real(b) - at) * over;
    begin = max(begin, min(first, last)), end = min(end, max(first, last));
  };
  pass(from.x, way.x, low.x, high.x), pass(from.y, way.y, low.y, high.y), pass(from.z, way.z, low.z, high.z);
  return {from + way * begin, begin < end};
}

inline constexpr int light_taps = 8;

/// Of a tap of a spiral that is even over a disc (Vogel 1979).
inline glm::vec2 on_disc(int tap) {
  const float angle = 2.399963f * static_cast<float>(tap);
  return std::sqrt((static_cast<float>(tap) + 0.5f) / light_taps) * glm::vec2(std::cos(angle), std::sin(angle));
}

/// Share of a light that gets to a place of the ground past fur of that darkness and the body.
HWY_INLINE Real light_past(const RasterScene& scene, std::size_t light, Vec3 place, Vec3 to_light, Vec3 stopped) {
  const GridPlace& grid = scene.grid->place();
  const GridEntry entry = grid_entry(grid, place, to_light);
  if (!any(entry.there)) return 1.0f;
  const CrossedLanes crossed = crossed_at(scene.grid->crossed(light), grid_lanes(grid, entry.place));
  return select(entry.there, luminance(let_through(crossed, stopped)), 1.0f);
}

/// The same of all of a light that is wide.
HWY_INLINE Real wide_light_past(const RasterScene& scene, std::size_t light, Vec3 place, Vec3 to_light, Vec3 stopped) {
  const LightSize& size = scene.light_sizes[light];
  if (!(size.radius > 0)) return light_past(scene, light, place, to_light, stopped);
  Real spread = size.radius;
  if (!size.far) spread = spread / max(length(Vec3(scene.optics.frame.lights[light].position) - place), 1e-3f);
  const Vec3 across = unit(cross(to_light, Vec3(1.0f, 0.0f, 0.0f))),
             up = cross(across, to_light);  // the light is above
  Real sum = 0.0f;
  for (int tap = 0; tap < light_taps; ++tap) {
    const glm::vec2 at = on_disc(tap);
    sum += light_past(scene, light, place, unit(to_light + spread * (at.x * across + at.y * up)), stopped);
  }
  return sum * (1.0f / light_taps);
}

/// Share of the ground's light that is missing at a place, as the tracer adds it up.
HWY_INLINE Real light_missing(const RasterScene& scene, Vec3 place) {
  const FrameOptics& optics = scene.optics;
  const FrameBlock& frame = optics.frame;
  const Vec3 crossed = Vec3(frame.ramp_root) * Vec3(frame.colour_above[0]);
  FrameLight from(optics);
  const Vec3 stopped = from.stopped_by_strand(crossed, 1.0f);
  Real whole = frame.weights.x, missing = frame.weights.x * scene.ground->contact * sky_hidden(*scene.sky, place);
  for (int i = 0; i < optics.lights; ++i) {
    const auto number = static_cast<Index>(i);
    const Arriving light = from.light_at(number, place);
    const Real arrives = frame.weights.y * max(light.to_light.y, 0.0f) * luminance(light.radiance);
    whole += arrives;
    if (!any(arrives > 0.0f)) continue;
    const Real past = wide_light_past(scene, number, place, light.to_light, stopped);
    missing += arrives * scene.ground->shadow * (1.0f - past);
  }
  return clamp(missing / max(whole, 1e-6f), 0.0f, 1.0f);
}

/// How dark the ground is where rays meet it.
HWY_INLINE Real ground_dark(const RasterScene& scene, Vec3 way) {
  const Real distance = (scene.ground->height - scene.camera.position.y) / min(way.y, -1e-9f);
  const Vec3 place = Vec3(scene.camera.position) + way * distance;
  const Real from_middle = length(Vec2{place.x, place.z});
  const Mask there = (way.y < -1e-9f) & (from_middle < ground_end);
  if (!any(there)) return 0.0f;
  const Real edge = 1.0f - smoothstep(ground_whole, ground_end, from_middle);
  return select(there, light_missing(scene, place) * edge, 0.0f);
}

/// Darkness at some places of a tile, a few pixels apart: it is as smooth as the grid's cells.
struct GroundKnots {
  static constexpr int apart = 4, side = tile_side / apart + 1, count = (side * side + 15) / 16 * 16;
  HWY_ALIGN float dark[count];

  HWY_INLINE GroundKnots(const RasterScene& scene, int left, int top) {
    for (int i = 0; i < count; i += lane_count) {
      const Real number = min(to_real(hn::Iota(int_tag, i)), static_cast<float>(side * side - 1));
      const Real row = floor((number + 0.5f) * (1.0f / side)), column = number - row * static_cast<float>(side);
      const Vec3 way = ray_through(scene.camera, mul_add(column, static_cast<float>(apart), static_cast<float>(left)),
                                   mul_add(row, static_cast<float>(apart), static_cast<float>(top)));
      store(ground_dark(scene, way), dark + i);
    }
  }

  /// At pixels from the tile's corner.
  HWY_INLINE Real at(Vec2 pixel) const {
    const Real x = pixel.x * (1.0f / apart), y = pixel.y * (1.0f / apart), left = floor(x), top = floor(y);
    const Int first = to_int(mul_add(top, static_cast<float>(side), left));
    const Real above = mix(gather(dark, first), gather(dark + 1, first), x - left);
    const Real below = mix(gather(dark + side, first), gather(dark + side + 1, first), x - left);
    return mix(above, below, y - top);
  }
};

HWY_INLINE void darken_all(const RasterScene& scene, int left, int top, std::span<float> through) {
  if (std::none_of(through.begin(), through.end(), [](float open) { return open > min_shown; })) return;
  const GroundKnots knots(scene, left, top);
  for (int block = 0; block < block_columns * block_rows; ++block) {
    float* open = &through[static_cast<std::size_t>(block * lane_count)];
    store(load(open) * (1.0f - knots.at(block_pixels(block))), open);
  }
}

}  // namespace pelage::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
