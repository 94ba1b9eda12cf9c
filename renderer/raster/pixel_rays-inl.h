// Rays through the pixels of a picture, one pixel in each lane.
#if defined(PELAGE_RASTER_PIXEL_RAYS_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef PELAGE_RASTER_PIXEL_RAYS_INL_H_
#undef PELAGE_RASTER_PIXEL_RAYS_INL_H_
#else
#define PELAGE_RASTER_PIXEL_RAYS_INL_H_
#endif

#include "renderer/optics/lanes-inl.h"
#include "renderer/raster/raster_scene.h"

HWY_BEFORE_NAMESPACE();
namespace pelage::HWY_NAMESPACE {

/// Returns the ray through a position of the picture, in pixels; its component along the view is 1.
HWY_INLINE Vec3 ray_through(const PictureCamera& camera, Real x, Real y) {
  const Real over = 1.0f / camera.scale;
  return Vec3(camera.forward) + ((x - camera.middle.x) * over) * Vec3(camera.right) -
         ((y - camera.middle.y) * over) * Vec3(camera.up);
}

/// A register holds a block of a tile's pixels in the order of pixel_in_tile. Blocks are numbered column by column.
inline constexpr int block_width = 4, block_height = lane_count / 4;
inline constexpr int block_columns = tile_side / block_width, block_rows = tile_side / block_height;
static_assert(lane_count % 4 == 0 && block_columns * block_rows <= 64);

/// Returns the middles of a block's pixels, in pixels from the tile's corner.
HWY_INLINE Vec2 block_pixels(int block) {
  const Int lanes = hn::Iota(int_tag, 0);
  return {to_real(hn::And(lanes, splat(3))) + (static_cast<float>(block_width * (block / block_rows)) + 0.5f),
          to_real(hn::ShiftRight<2>(lanes)) + (static_cast<float>(block_height * (block % block_rows)) + 0.5f)};
}

}  // namespace pelage::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
