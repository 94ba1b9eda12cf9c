// What shells let through on the way from a light, for several texels of its maps at once: the light that comes to each
// height (GPU fur 3.1).
#if defined(PELAGE_MARCHED_SHELL_SHADOW_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef PELAGE_MARCHED_SHELL_SHADOW_INL_H_
#undef PELAGE_MARCHED_SHELL_SHADOW_INL_H_
#else
#define PELAGE_MARCHED_SHELL_SHADOW_INL_H_
#endif

#include "renderer/marched/march-inl.h"
#include "renderer/shaders/constants.h"

HWY_BEFORE_NAMESPACE();
namespace pelage::HWY_NAMESPACE {

/// Share of a light that comes to the boundaries of even shells, the skin first.
class KeptLight {
 public:
  KeptLight() { std::fill_n(&kept_[0][0], (shadow_shells + 1) * lane_count, 1.0f); }

  /// Of a segment all that lies above a boundary stops light on its way there.
  void stop(int lane, float lowest, float opacity) {
    const int top = static_cast<int>(lowest * shadow_shells + 0.001f);
    for (int boundary = 0; boundary <= std::min(top, shadow_shells); ++boundary) kept_[boundary][lane] *= 1 - opacity;
  }
  float at(int boundary, int lane) const { return kept_[boundary][lane]; }

 private:
  float kept_[shadow_shells + 1][lane_count];
};

/// One step of all lanes. Fur that faces away from the light leaves no trace.
HWY_INLINE void stop_light(const MarchScene& scene, const Ray& ray, const TileScratch& scratch,
                           const Segments& segments, const End& near, const End& far, KeptLight& kept) {
  float opacity[lane_count];
  store(select(segments.there, slab_of(scene, ray, segments, near, far).slab.opacity, 0.0f), opacity);
  for (std::uint32_t lanes = bits_of(segments.there); lanes != 0; lanes &= lanes - 1) {
    const int lane = std::countr_zero(lanes);
    if (scratch.records[segments.near[lane]].facing)
      kept.stop(lane, std::min(segments.near_height[lane], segments.far_height[lane]), opacity[lane]);
  }
}

}  // namespace pelage::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
