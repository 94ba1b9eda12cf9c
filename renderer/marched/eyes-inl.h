// Eyes between the skin and the fur of a tile: their depths before the fur is rasterized, their light behind it.
#if defined(PELAGE_MARCHED_EYES_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef PELAGE_MARCHED_EYES_INL_H_
#undef PELAGE_MARCHED_EYES_INL_H_
#else
#define PELAGE_MARCHED_EYES_INL_H_
#endif

#include <bit>

#include "renderer/marched/march-inl.h"
#include "renderer/optics/eye-inl.h"

HWY_BEFORE_NAMESPACE();
namespace pelage::HWY_NAMESPACE {

HWY_INLINE EyeHit eye_hit(const MarchScene& scene, int number, Vec3 way) {
  const EyeEntry& eye = scene.optics.eyes.block.eyes[static_cast<std::size_t>(number)];
  return meet_eye(eye, scene.eyes[static_cast<std::size_t>(number)].viewer, in_eye_frame(eye, way),
                  scene.optics.frame.viewpoint.w);
}

/// The eyes of a group that are nearer than what it has.
HWY_INLINE void add_eye(const MarchScene& scene, int number, int group, Vec3 way, EyePixels& eyes) {
  const EyeEntry& eye = scene.optics.eyes.block.eyes[static_cast<std::size_t>(number)];
  const EyeCamera& camera = scene.eyes[static_cast<std::size_t>(number)];
  const EyeHit hit = eye_hit(scene, number, way);
  const Real distance = eye.right.w * dot(hit.nearest - Vec3(camera.viewer), Vec3(camera.forward));
  const Real inverse = 1.0f / max(distance, 1e-12f);
  const auto begin = static_cast<std::size_t>(group * lane_count);
  const Mask nearer = hit.there & (inverse >= load(&eyes.inverse[begin]));
  store(select(nearer, inverse, load(&eyes.inverse[begin])), &eyes.inverse[begin]);
  for (std::uint32_t lanes = bits_of(nearer); lanes != 0; lanes &= lanes - 1)
    eyes.number[begin + static_cast<std::size_t>(std::countr_zero(lanes))] = static_cast<std::int8_t>(number);
}

/// After the skin, before the fur, which ends at what is nearest.
HWY_INLINE void raster_eyes(const MarchScene& scene, const Tile& tile, TileScratch& scratch) {
  for (std::size_t number = 0; number < scene.eyes.size(); ++number) {
    const PixelBox& box = scene.eyes[number].box;
    const int left = std::max(box.left - tile.left, 0) / group_width,
              top = std::max(box.top - tile.top, 0) / group_height;
    const int right = (std::min(box.right - tile.left, Tile::side) + group_width - 1) / group_width;
    const int bottom = (std::min(box.bottom - tile.top, Tile::side) + group_height - 1) / group_height;
    if (left >= right || top >= bottom) continue;
    scratch.eyes.begin(scratch.skin);
    for (int y = top; y < bottom; ++y) {
      for (int x = left; x < right; ++x) {
        const Vec3 way = way_of(scene, tile.left + x * group_width, tile.top + y * group_height);
        add_eye(scene, static_cast<int>(number), y * groups_across + x, way, scratch.eyes);
      }
    }
  }
}

/// Bit k: eye k is seen in the group.
HWY_INLINE std::uint32_t eyes_of(const TileScratch& scratch, int group) {
  std::uint32_t numbers = 0;
  for (int i = 0; scratch.eyes.there && i < lane_count; ++i) {
    const int number = scratch.eyes.number[static_cast<std::size_t>(group * lane_count + i)];
    if (number >= 0) numbers |= 1u << number;
  }
  return numbers;
}

/// Lids and cornea count as what reflects, not as shadow: all of the lights' share is left.
HWY_INLINE void keep_eye_aovs(const MarchScene& scene, const TileScratch& scratch, int group, const EyeEntry& eye,
                              const EyeHit& hit, Vec3 light, Real weight, Seen& seen) {
  const EyeSurface surface = eye_surface(scene.optics, eye, hit);
  Direct direct = Direct::none();
  const Vec3 of_lights = max(light - eye_light(scene.optics, eye, hit, 0), 0.0f);
  direct.add(of_lights, of_lights);
  const Real inverse = load(&scratch.eyes.inverse[static_cast<std::size_t>(group * lane_count)]);
  seen.aovs->add({surface.place, surface.normal, Vec3(0.0f), surface.albedo, direct, 0.0f, inverse}, weight,
                 seen.through);
}

/// Behind all fur that is before the skin: `numbers` of eyes_of.
HWY_INLINE void see_eyes(const MarchScene& scene, const Ray& ray, const TileScratch& scratch, int group,
                         std::uint32_t numbers, Seen& seen) {
  for (; numbers != 0; numbers &= numbers - 1) {
    const int number = std::countr_zero(numbers);
    float mine[lane_count];
    for (int i = 0; i < lane_count; ++i)
      mine[i] = scratch.eyes.number[static_cast<std::size_t>(group * lane_count + i)] == number ? 1.0f : 0.0f;
    EyeHit hit = eye_hit(scene, number, ray.way);
    hit.there = hit.there & (load(mine) > 0.5f) & (seen.through > 0.002f);
    if (!any(hit.there)) continue;
    const Real weight = select(hit.there, seen.through * hit.covered, 0.0f);
    const EyeEntry& eye = scene.optics.eyes.block.eyes[static_cast<std::size_t>(number)];
    const Vec3 light = eye_light(scene.optics, eye, hit, scene.optics.lights);
    seen.light += light * weight;
    if (seen.aovs) keep_eye_aovs(scene, scratch, group, eye, hit, light, weight, seen);
    seen.through -= weight;
  }
}

}  // namespace pelage::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
