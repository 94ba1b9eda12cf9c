// Draws eyes between the skin and the strands of a tile: what they hide, and their light behind the strands.
#if defined(PELAGE_RASTER_EYES_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef PELAGE_RASTER_EYES_INL_H_
#undef PELAGE_RASTER_EYES_INL_H_
#else
#define PELAGE_RASTER_EYES_INL_H_
#endif

#include "renderer/optics/eye-inl.h"
#include "renderer/raster/kernels.h"
#include "renderer/raster/pixel_rays-inl.h"
#include "renderer/raster/strand_light-inl.h"

HWY_BEFORE_NAMESPACE();
namespace pelage::HWY_NAMESPACE {

using EyeHit = EyeShading::EyeHit;

HWY_INLINE EyeShading eye_of(const RasterScene& scene, std::size_t number) {
  return {scene.optics, scene.eyes[number], number};
}

/// Returns the rays through the pixels of a block of the tile with this upper left corner.
HWY_INLINE Vec3 block_rays(const RasterScene& scene, int left, int top, int block) {
  const Vec2 at = block_pixels(block);
  return ray_through(scene.camera, at.x + static_cast<float>(left), at.y + static_cast<float>(top));
}

/// Marks the pixels of a block where the eye is nearer than what is already there.
HWY_INLINE void intersect_block(const RasterScene& scene, std::size_t number, Vec3 ray, float* background_inverse,
                                std::int8_t* numbers) {
  const EyeCamera& camera = scene.eyes[number];
  EyeShading shading = eye_of(scene, number);
  const EyeHit hit = shading.intersect_eye(shading.in_eye_frame(ray), scene.optics.frame.viewpoint.w);
  const Real distance = shading.eye.right.w * dot(hit.nearest - Vec3(camera.viewer), Vec3(camera.forward));
  const Real inverse = 1.0f / max(distance, 1e-12f), before = load(background_inverse);
  const Mask nearer = hit.there & (distance > near_distance) & (inverse >= before);
  store(select(nearer, inverse, before), background_inverse);
  for (std::uint32_t lanes = bits_of(nearer); lanes != 0; lanes &= lanes - 1)
    numbers[std::countr_zero(lanes)] = static_cast<std::int8_t>(number);
}

HWY_INLINE void intersect_all(const RasterScene& scene, int left, int top, float* background_inverse,
                              std::int8_t* numbers) {
  for (std::size_t number = 0; number < scene.eyes.size(); ++number) {
    const PixelBox& box = scene.eyes[number].box;
    if (box.left >= left + tile_side || box.top >= top + tile_side || box.right <= left || box.bottom <= top) continue;
    for (int block = 0; block < block_columns * block_rows; ++block)
      intersect_block(scene, number, block_rays(scene, left, top, block), background_inverse + block * lane_count,
                      numbers + block * lane_count);
  }
}

/// Returns the eyes that are visible in a block: bit k for eye k.
HWY_INLINE std::uint32_t eyes_of_block(const std::int8_t* numbers) {
  std::uint32_t seen = 0;
  for (int i = 0; i < lane_count; ++i)
    if (numbers[i] >= 0) seen |= 1u << numbers[i];
  return seen;
}

/// Returns what the scene shows of an eye. For RasterOutput::shadow, lids and cornea count as part of the reflection,
/// not as shadow: both values are the same.
HWY_INLINE Vec3 output_value(const RasterScene& scene, EyeShading& shading, const EyeHit& hit, Real inverse) {
  const Real none = 0.0f;
  switch (scene.output) {
    case RasterOutput::objects: return object_mask(scene, eyes_object);
    case RasterOutput::albedo:
    case RasterOutput::normal: {
      const EyeShading::EyeSurface surface = shading.eye_surface(hit);
      return scene.output == RasterOutput::albedo ? surface.albedo : surface.normal;
    }
    case RasterOutput::field:
    case RasterOutput::tangent:
    case RasterOutput::count:
    case RasterOutput::strand: return {none, none, none};
    case RasterOutput::distance: return {1.0f / max(inverse, 1e-12f), none, none};
    case RasterOutput::depth: return {inverse, none, none};
    default: break;
  }
  const bool lights_alone = scene.output == RasterOutput::direct || scene.output == RasterOutput::shadow;
  Vec3 sent(0.0f);
  for (int part = 0; part < (lights_alone ? 2 : 1); ++part) {  // a loop, so that eye_light is inlined only once
    if (part == 1) shading.eye_lights = 0;
    const Vec3 light = shading.eye_light(hit);
    sent = part == 0 ? light : max(sent - light, 0.0f);
  }
  if (scene.output != RasterOutput::shadow) return sent;
  return {luminance(sent), luminance(sent), none};
}

HWY_INLINE void light_eye(const RasterScene& scene, std::size_t number, Vec3 ray, const std::int8_t* numbers,
                          const float* background_inverse, std::size_t at, TileSums& sums) {
  float mine[lane_count];
  for (int i = 0; i < lane_count; ++i) mine[i] = numbers[i] == static_cast<std::int8_t>(number) ? 1.0f : 0.0f;
  EyeShading shading = eye_of(scene, number);
  EyeHit hit = shading.intersect_eye(shading.in_eye_frame(ray), scene.optics.frame.viewpoint.w);
  const Real transmittance = load(sums.transmittance + at);
  hit.there = hit.there & (load(mine) > 0.5f) & (transmittance > min_visible);
  if (!any(hit.there)) return;
  Real weight = select(hit.there, transmittance * hit.covered, 0.0f);
  const Real left_over = transmittance - weight;
  if (scene.output == RasterOutput::depth) weight = select((transmittance >= 0.5f) & (left_over < 0.5f), 1.0f, 0.0f);
  const Vec3 light = output_value(scene, shading, hit, load(background_inverse + at));
  store(mul_add(light.x, weight, load(sums.red + at)), sums.red + at);
  store(mul_add(light.y, weight, load(sums.green + at)), sums.green + at);
  store(mul_add(light.z, weight, load(sums.blue + at)), sums.blue + at);
  store(left_over, sums.transmittance + at);
}

HWY_INLINE void light_eyes_of(const RasterScene& scene, int left, int top, const std::int8_t* numbers,
                              const float* background_inverse, TileSums& sums) {
  for (int block = 0; block < block_columns * block_rows; ++block) {
    const int at = block * lane_count;
    std::uint32_t seen = eyes_of_block(numbers + at);
    if (seen == 0) continue;
    const Vec3 ray = block_rays(scene, left, top, block);
    for (; seen != 0; seen &= seen - 1)
      light_eye(scene, static_cast<std::size_t>(std::countr_zero(seen)), ray, numbers + at, background_inverse,
                static_cast<std::size_t>(at), sums);
  }
}

}  // namespace pelage::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
