// Shadows that other parts of the body cast, for several pixels at once: the penumbras of renderer/shaders/shadow.glsl.
#if defined(PELAGE_OPTICS_SHADOWS_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef PELAGE_OPTICS_SHADOWS_INL_H_
#undef PELAGE_OPTICS_SHADOWS_INL_H_
#else
#define PELAGE_OPTICS_SHADOWS_INL_H_
#endif

#include <algorithm>
#include <cmath>

#include "renderer/optics/lanes-inl.h"
#include "renderer/optics/shadow_optics.h"
#include "renderer/shaders/constants.h"

HWY_BEFORE_NAMESPACE();
namespace pelage::HWY_NAMESPACE {

/// A place as a light sees it.
struct OnLightMap {
  Vec2 at;  // of the map's side
  Real w, depth;
};

HWY_INLINE OnLightMap on_light_map(const ShadowCaster& caster, Vec3 place) {
  const glm::mat4& m = caster.to_light;
  const auto clip = [&](int row) HWY_ATTR {
    return mul_add(place.x, m[0][row], mul_add(place.y, m[1][row], mul_add(place.z, m[2][row], m[3][row])));
  };
  const Real w = max(clip(3), 1e-4f);  // beside a light that does not see the place
  return {{0.5f * clip(0) / w + 0.5f, 0.5f - 0.5f * clip(1) / w}, w, dot(Vec3(caster.axis), place) + caster.axis.w};
}

/// The nearest texel; beyond the map's edge that at it.
HWY_INLINE Real depth_at(const ShadowCaster& caster, Vec2 at) {
  const float side = static_cast<float>(caster.side);
  const Real x = clamp(floor(at.x * side), 0.0f, side - 1.0f), y = clamp(floor(at.y * side), 0.0f, side - 1.0f);
  return gather(caster.depths, hn::Add(hn::Mul(to_int(y), whole(caster.side)), to_int(x)));
}

/// How a light's blocked share is looked for around a place: the map's plane, and the skin's slope on it.
struct LightDisc {
  OnLightMap middle;
  Real spread;    // half of the light's width over its distance
  Real per_size;  // of the map's side
  Real texel;     // sizes
  Vec2 slope;     // of the skin: depth over distance across
};

HWY_INLINE LightDisc light_disc(const ShadowCaster& caster, Vec3 place, Vec3 normal) {
  const glm::mat4& m = caster.to_light;
  const glm::vec3 right(m[0].x, m[1].x, m[2].x), up(m[0].y, m[1].y, m[2].y);
  const float scale = glm::length(right);
  LightDisc disc;
  disc.middle = on_light_map(caster, place);
  disc.spread = caster.spread / disc.middle.w, disc.per_size = 0.5f * scale / disc.middle.w;
  disc.texel = 1.0f / (disc.per_size * static_cast<float>(caster.side));
  const Real facing = -dot(normal, Vec3(caster.axis)), over = 1.0f / (scale * max(facing, 0.2f));
  const Mask lit = facing > 0.0f;
  disc.slope = {select(lit, dot(normal, Vec3(right)) * over, 0.0f), select(lit, dot(normal, Vec3(up)) * over, 0.0f)};
  return disc;
}

/// How far in front of the skin's plane the body lies: the sum over those taps that lie in front, and their count.
struct Blockers {
  Real before, count;
};

HWY_INLINE Blockers blockers(const ShadowCaster& caster, const LightDisc& disc, Real room, Real radius, int taps) {
  const Real bias = room + disc.texel * length(disc.slope);
  Blockers found{0.0f, 0.0f};
  float x = 1, y = 0;  // turned by the golden angle from tap to tap
  for (int tap = 0; tap < taps; ++tap) {
    const Real far = radius * std::sqrt((static_cast<float>(tap) + 0.5f) / static_cast<float>(taps));
    const Vec2 off{far * x, far * y};
    const Real seen =
        depth_at(caster, {disc.middle.at.x + disc.per_size * off.x, disc.middle.at.y - disc.per_size * off.y});
    const Real before = disc.middle.depth + disc.slope.x * off.x + disc.slope.y * off.y - seen;
    found.before += select(before > bias, before, 0.0f), found.count += select(before > bias, 1.0f, 0.0f);
    const float turned = -0.7373688f * x - 0.6754903f * y;
    y = 0.6754903f * x - 0.7373688f * y, x = turned;
  }
  return found;
}

/// What part of the light the body leaves in sight of a place on the fur's hull (Fernando 2005). What lies no further
/// in front than the hull is high is fur that it grows into, in folds, and does not count.
HWY_INLINE Real past_body(const ShadowCaster& caster, Vec3 open, Real hull, Vec3 normal) {
  constexpr int search_taps = 8, penumbra_taps = 16;
  constexpr float penumbra_bias = 0.003f, min_fold = 0.017f, furthest_caster = 0.35f;  // sizes
  const LightDisc disc = light_disc(caster, open, normal);
  const Real room = penumbra_bias + max(hull, min(10.0f * hull, min_fold));
  const Real least = 1.5f * disc.texel, most = max(disc.spread * furthest_caster, least);
  const Blockers found = blockers(caster, disc, room, most, search_taps);
  const Mask agree = (found.count < 0.5f) | (found.count > search_taps - 0.5f);
  const Real searched = found.count * (1.0f / search_taps);
  if (all(agree)) return 1.0f - searched;
  const Real radius = clamp(disc.spread * found.before / max(found.count, 1.0f), least, most);
  const Real hidden = blockers(caster, disc, room, radius, penumbra_taps).count * (1.0f / penumbra_taps);
  return 1.0f - select(agree, searched, hidden);
}

/// What guided curves let through (past_curves of shadow.glsl): the map holds the share of light that passes, which
/// counts below the nearest curve of the four texels that are mixed.
HWY_INLINE Real past_curves(const ShadowCaster& caster, Vec3 place) {
  constexpr float curve_bias = 0.001f, penumbra = 0.09f;  // sizes; width over the distance that the shadow falls
  const OnLightMap on = on_light_map(caster, place);
  const float side = static_cast<float>(caster.side);
  const Real x = on.at.x * side - 0.5f, y = on.at.y * side - 0.5f;
  const Mask inside = (on.at.x >= 0.0f) & (on.at.x <= 1.0f) & (on.at.y >= 0.0f) & (on.at.y <= 1.0f);
  const Real left = floor(x), top = floor(y), px = x - left, py = y - top;
  Real kept = 0.0f, nearest = 1e30f;
  for (int k = 0; k < 4; ++k) {
    const Real column = clamp(left + static_cast<float>(k & 1), 0.0f, side - 1.0f);
    const Real row = clamp(top + static_cast<float>(k >> 1), 0.0f, side - 1.0f);
    const Int at = hn::ShiftLeft<1>(hn::Add(hn::Mul(to_int(row), whole(caster.side)), to_int(column)));
    const Real weight = (k & 1 ? px : 1.0f - px) * (k & 2 ? py : 1.0f - py);
    kept += weight * gather(&caster.curves[0].x, at), nearest = min(nearest, gather(&caster.curves[0].y, at));
  }
  const Real below = on.depth - nearest;
  const glm::mat4& m = caster.to_light;
  const Real texels = 0.5f * side * glm::length(glm::vec3(m[0].x, m[1].x, m[2].x)) / on.w;
  const Real stopped = (1.0f - kept) / (1.0f + penumbra * max(below, 0.0f) * texels);
  return select(inside, 1.0f - stopped * smoothstep(curve_bias, 3.0f * curve_bias, below), 1.0f);
}

/// Share of a light that other parts of the body and guided curves let through to fur whose hull is at `open`, and as
/// high as `hull`, or to skin.
HWY_INLINE Real cast_light(const ShadowCaster& caster, Vec3 place, Vec3 open, Real hull, Vec3 normal) {
  if (!caster.depths) return 1.0f;
  const Real kept = past_body(caster, open, hull, normal);
  return caster.curves ? kept * past_curves(caster, place) : kept;
}

}  // namespace pelage::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
