// The ground behind a model: the twin of renderer/passes/ground/ground.frag without maps of shadows.
#if defined(PELAGE_MARCHED_GROUND_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef PELAGE_MARCHED_GROUND_INL_H_
#undef PELAGE_MARCHED_GROUND_INL_H_
#else
#define PELAGE_MARCHED_GROUND_INL_H_
#endif

#include "renderer/marched/ground_contact.h"
#include "renderer/marched/march-inl.h"

HWY_BEFORE_NAMESPACE();
namespace pelage::HWY_NAMESPACE {

/// Share of the sky that the model hides, [0, 1]: between the four nearest numbers of the map.
HWY_INLINE Real contact_at(const GroundContact& contact, Real x, Real z) {
  constexpr float per_size = GroundContact::side / (2 * GroundContact::extent), last = GroundContact::side - 2.0f;
  const Real column = (x + GroundContact::extent) * per_size - 0.5f, row = (z + GroundContact::extent) * per_size - 0.5f;
  const Real left = clamp(floor(column), 0.0f, last), top = clamp(floor(row), 0.0f, last);
  const Real across = clamp(column - left, 0.0f, 1.0f), down = clamp(row - top, 0.0f, 1.0f);
  const Int at = to_int(top * static_cast<float>(GroundContact::side) + left);
  const float* first = contact.hidden.data();
  const Real above = mix(gather(first, at), gather(first + 1, at), across);
  const Real below = mix(gather(first + GroundContact::side, at), gather(first + GroundContact::side + 1, at), across);
  const Mask inside = (abs(x) < GroundContact::extent) & (abs(z) < GroundContact::extent);
  return select(inside, mix(above, below, down), 0.0f);
}

/// How dark the ground is where a ray meets it: the light that is missing, which without maps is the same share of all
/// lights, as wide as the sky.
HWY_INLINE Real ground_dark(const GroundOptics& ground, const MarchScene& scene, const Ray& ray) {
  const Real distance = (ground.height - scene.viewpoint.y) / min(ray.way.y, -1e-9f);
  const Vec3 place = Vec3(scene.viewpoint) + ray.way * distance;
  const Mask there = (ray.way.y < -1e-9f) & (abs(place.x) <= GroundOptics::extent) & (abs(place.z) <= GroundOptics::extent);
  if (!any(there)) return 0.0f;
  const Real edge = 1.0f - smoothstep(1.0f, 3.5f, length(Vec2{place.x, place.z}));
  return select(there, clamp(ground.contact * contact_at(*ground.hidden, place.x, place.z), 0.0f, 1.0f) * edge, 0.0f);
}

}  // namespace pelage::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
