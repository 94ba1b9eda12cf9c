// Darkens the ground behind a model where the model and its fur take light from it.
#if defined(PELAGE_RASTER_GROUND_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef PELAGE_RASTER_GROUND_INL_H_
#undef PELAGE_RASTER_GROUND_INL_H_
#else
#define PELAGE_RASTER_GROUND_INL_H_
#endif

#include <algorithm>

#include "renderer/raster/kernels.h"
#include "renderer/raster/pixel_rays-inl.h"
#include "renderer/raster/scene_light-inl.h"

HWY_BEFORE_NAMESPACE();
namespace pelage::HWY_NAMESPACE {

/// The ground's darkness at positions `apart` pixels apart in a tile. It varies no faster than the grid's cells, so
/// that interpolation between these is enough.
struct GroundKnots {
  static constexpr int apart = 4, side = tile_side / apart + 1, count = (side * side + 15) / 16 * 16;
  HWY_ALIGN float dark[count];

  HWY_INLINE GroundKnots(const RasterScene& scene, int left, int top) {
    SceneLight from(scene);
    for (int i = 0; i < count; i += lane_count) {
      const Real number = min(to_real(hn::Iota(int_tag, i)), static_cast<float>(side * side - 1));
      const Real row = floor((number + 0.5f) * (1.0f / side)), column = number - row * static_cast<float>(side);
      const Vec3 ray = ray_through(scene.camera, mul_add(column, static_cast<float>(apart), static_cast<float>(left)),
                                   mul_add(row, static_cast<float>(apart), static_cast<float>(top)));
      store(from.ground_darkness(ray), dark + i);
    }
  }

  /// Returns the darkness at a position in pixels from the tile's corner.
  HWY_INLINE Real at(Vec2 pixel) const {
    const Real x = pixel.x * (1.0f / apart), y = pixel.y * (1.0f / apart), left = floor(x), top = floor(y);
    const Int first = to_int(mul_add(top, static_cast<float>(side), left));
    const Real above = mix(gather(dark, first), gather(dark + 1, first), x - left);
    const Real below = mix(gather(dark + side, first), gather(dark + side + 1, first), x - left);
    return mix(above, below, y - top);
  }
};

HWY_INLINE void darken_all(const RasterScene& scene, int left, int top, std::span<float> transmittances) {
  if (std::none_of(transmittances.begin(), transmittances.end(),
                   [](float pixel_transmittance) { return pixel_transmittance > min_visible; }))
    return;
  const GroundKnots knots(scene, left, top);
  for (int block = 0; block < block_columns * block_rows; ++block) {
    float* pixel_transmittance = &transmittances[static_cast<std::size_t>(block * lane_count)];
    store(load(pixel_transmittance) * (1.0f - knots.at(block_pixels(block))), pixel_transmittance);
  }
}

}  // namespace pelage::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
