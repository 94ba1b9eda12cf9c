// The ground behind a model: the twin of renderer/passes/ground/ground.frag.
#if defined(PELAGE_MARCHED_GROUND_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef PELAGE_MARCHED_GROUND_INL_H_
#undef PELAGE_MARCHED_GROUND_INL_H_
#else
#define PELAGE_MARCHED_GROUND_INL_H_
#endif

#include <cmath>

#include "renderer/marched/ground_contact.h"
#include "renderer/marched/march-inl.h"

HWY_BEFORE_NAMESPACE();
namespace pelage::HWY_NAMESPACE {

/// Share of the sky that the model hides, [0, 1]: between the four nearest numbers of the map.
HWY_INLINE Real contact_at(const GroundContact& contact, Real x, Real z) {
  constexpr float per_size = GroundContact::side / (2 * GroundContact::extent), last = GroundContact::side - 2.0f;
  const Real column = (x + GroundContact::extent) * per_size - 0.5f,
             row = (z + GroundContact::extent) * per_size - 0.5f;
  const Real left = clamp(floor(column), 0.0f, last), top = clamp(floor(row), 0.0f, last);
  const Real across = clamp(column - left, 0.0f, 1.0f), down = clamp(row - top, 0.0f, 1.0f);
  const Int at = to_int(top * static_cast<float>(GroundContact::side) + left);
  const float* first = contact.hidden.data();
  const Real above = mix(gather(first, at), gather(first + 1, at), across);
  const Real below = mix(gather(first + GroundContact::side, at), gather(first + GroundContact::side + 1, at), across);
  const Mask inside = (abs(x) < GroundContact::extent) & (abs(z) < GroundContact::extent);
  return select(inside, mix(above, below, down), 0.0f);
}

inline constexpr int ground_taps = 40;

/// Of a tap of a spiral that is even over a disc.
inline glm::vec2 spiral(int tap) {
  const float angle = 2.399963f * static_cast<float>(tap);
  return std::sqrt((static_cast<float>(tap) + 0.5f) / ground_taps) * glm::vec2(std::cos(angle), std::sin(angle));
}

/// Depths of taps around a place of a light's map that lie before a depth: their sum and their count.
HWY_INLINE Blockers before_ground(const ShadowCaster& caster, const OnLightMap& on, Real radius) {
  Blockers found{0.0f, 0.0f};
  for (int tap = 0; tap < ground_taps; ++tap) {
    const glm::vec2 off = spiral(tap);
    const Vec2 at{on.at.x + radius * off.x, on.at.y + radius * off.y};
    const Real depth = depth_at(caster, at);
    const Mask inside = (at.x >= 0.0f) & (at.x <= 1.0f) & (at.y >= 0.0f) & (at.y <= 1.0f);
    const Mask blocks = inside & (depth < on.depth - static_cast<float>(cast_bias));
    found.before += select(blocks, depth, 0.0f), found.count += select(blocks, 1.0f, 0.0f);
  }
  return found;
}

/// Share of a light that the body lets through to the ground: its shadow is softer the further it falls.
HWY_INLINE Real past_body_on_ground(const ShadowCaster& caster, Vec3 place) {
  const OnLightMap on = on_light_map(caster, place);
  const Blockers found = before_ground(caster, on, 0.05f);
  if (!any(found.count > 0.0f)) return 1.0f;
  const Real before = on.depth - found.before / max(found.count, 1.0f);
  Real radius = 0.0f;
  if (caster.edge == ShadowEdge::soft) radius = clamp(0.09f * before, 0.004f, 0.05f);
  if (caster.edge == ShadowEdge::penumbra) {
    const LightDisc disc = light_disc(caster, place, Vec3(0.0f, 1.0f, 0.0f));
    radius = disc.spread * disc.per_size * before;
  }
  const Real hidden = before_ground(caster, on, radius).count * (1.0f / ground_taps);
  return select(found.count > 0.0f, 1.0f - hidden, 1.0f);
}

/// Share of the light that is missing at a place where `hidden` of the sky is.
HWY_INLINE Real light_missing(const MarchScene& scene, Vec3 place, Real hidden) {
  const FrameOptics& optics = scene.optics;
  const float ambient = optics.frame.weights.x;
  Real whole = ambient, here = ambient * (1.0f - hidden);
  for (int i = 0; i < optics.lights; ++i) {
    const Arriving light = light_at(optics, i, place);
    const Real arrives = optics.frame.weights.y * max(light.to_light.y, 0.0f) * luminance(light.radiance);
    whole += arrives;
    const ShadowCaster& caster = optics.casters[static_cast<std::size_t>(i)];
    if (!caster.depths || caster.edge == ShadowEdge::none) {
      here += arrives * (1.0f - hidden);  // a light without a map counts as wide
      continue;
    }
    Real kept = past_body_on_ground(caster, place);
    if (caster.curves) kept *= past_curves(caster, place);
    here += arrives * mix(Real(1.0f), kept, scene.ground.shadow);
  }
  return clamp(1.0f - here / max(whole, 1e-6f), 0.0f, 1.0f);
}

/// How dark the ground is where a ray meets it. Without maps the share that is missing is the same of all lights.
HWY_INLINE Real ground_dark(const MarchScene& scene, const Ray& ray) {
  const GroundOptics& ground = scene.ground;
  const Real distance = (ground.height - scene.viewpoint.y) / min(ray.way.y, -1e-9f);
  const Vec3 place = Vec3(scene.viewpoint) + ray.way * distance;
  const Mask there =
      (ray.way.y < -1e-9f) & (abs(place.x) <= GroundOptics::extent) & (abs(place.z) <= GroundOptics::extent);
  if (!any(there)) return 0.0f;
  const Real edge = 1.0f - smoothstep(1.0f, 3.5f, length(Vec2{place.x, place.z}));
  const Real hidden = ground.contact * contact_at(*ground.hidden, place.x, place.z);
  const Real missing = scene.optics.casters.empty() ? hidden : light_missing(scene, place, hidden);
  return select(there, missing * edge, 0.0f);
}

}  // namespace pelage::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
