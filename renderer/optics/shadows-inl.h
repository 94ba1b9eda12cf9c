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
  const Real thinned = caster.edge == ShadowEdge::hard ? Real(1.0f) : 1.0f + penumbra * max(below, 0.0f) * texels;
  const Real stopped = (1.0f - kept) / thinned;
  return select(inside, 1.0f - stopped * smoothstep(curve_bias, 3.0f * curve_bias, below), 1.0f);
}

/// Between the four nearest of a map's numbers; beyond its edge those at it. `map`: the first of each lane's map;
/// `stride`: floats from one to the next.
HWY_INLINE Real between_texels(const float* first, Int map, int stride, int side, Vec2 at) {
  const float last = static_cast<float>(side) - 1;
  const Real x = clamp(at.x * static_cast<float>(side) - 0.5f, 0.0f, last);
  const Real y = clamp(at.y * static_cast<float>(side) - 0.5f, 0.0f, last);
  const Real left = floor(x), top = floor(y), right = min(left + 1.0f, last), bottom = min(top + 1.0f, last);
  const auto texel = [&](Real column, Real row) HWY_ATTR {
    const Int texel_at = hn::Add(hn::Mul(to_int(row), whole(side)), to_int(column));
    return gather(first, hn::Add(map, hn::Mul(texel_at, whole(stride))));
  };
  return mix(mix(texel(left, top), texel(right, top), x - left),
             mix(texel(left, bottom), texel(right, bottom), x - left), y - top);
}

/// A hard edge, or 1 - scale width / depth below what casts the shadow (past_body of shadow.glsl).
HWY_INLINE Real past_edge(const ShadowCaster& caster, Vec3 place) {
  constexpr auto bias = static_cast<float>(cast_bias);
  constexpr float shadow_width = 0.03f;  // sizes from the edge of a shadow to where its map is white
  const OnLightMap on = on_light_map(caster, place);
  const Real below = on.depth - depth_at(caster, on.at);
  const Mask hidden = below > bias;
  if (!any(hidden)) return 1.0f;
  if (caster.edge == ShadowEdge::hard) return select(hidden, 0.0f, 1.0f);
  const float* widths = &caster.widths[0].x;
  const Real share = between_texels(widths, whole(0), 2, caster.width_side, on.at);
  const Real depth = between_texels(widths + 1, whole(0), 2, caster.width_side, on.at);
  const Real white = clamp((share * on.depth - depth) / max(below, 1e-9f), 0.0f, share);  // .5 at the edge
  const Real width = shadow_width * max(2.0f * white - 1.0f, 0.0f);
  const Real fade = smoothstep(bias, 3 * bias, below);
  return select(hidden, 1.0f - fade * clamp(caster.scale * width / max(below, 1e-9f), 0.0f, 1.0f), 1.0f);
}

/// Optical depth of the shells above a place from maps of them; what the estimate says where the map shows another part
/// of the body, or where the surface is turned so far away that its shells leave no trace on the map (shell_depth of
/// shadow.glsl). `facing` is N.L.
HWY_INLINE Real shell_depth(const ShadowCaster& caster, Vec3 place, Vec3 open, Real height, Real facing,
                            Real estimate) {
  const ShellShadow& shells = caster.shells;
  if (!shells.kept) return estimate;
  constexpr float count = shadow_shells, own_part = 0.5f / slice_count;  // what lies nearer is the strand itself
  constexpr auto bias = static_cast<float>(cast_bias);
  const glm::mat4& m = shells.to_light;
  const auto clip = [&](int row) HWY_ATTR {
    return mul_add(place.x, m[0][row], mul_add(place.y, m[1][row], mul_add(place.z, m[2][row], m[3][row])));
  };
  const Real w = max(clip(3), 1e-4f);
  const Vec2 at{0.5f * clip(0) / w + 0.5f, 0.5f - 0.5f * clip(1) / w};
  const Real in_shells = min(height + own_part, 1.0f) * count, low = min(floor(in_shells), count - 1);
  const auto kept_at = [&](Real boundary) HWY_ATTR {
    const Int map = hn::Mul(to_int(boundary), whole(shells.side * shells.side));
    return between_texels(shells.kept, map, 1, shells.side, at);
  };
  const Real kept = mix(kept_at(low), kept_at(low + 1.0f), in_shells - low);
  const OnLightMap on = on_light_map(caster, caster.edge == ShadowEdge::penumbra ? open : place);
  const Real below = on.depth - depth_at(caster, on.at);
  const Real estimated = max(smoothstep(bias, 2 * bias, below), 1.0f - smoothstep(0.05f, 0.35f, facing));
  return mix(-0.69314718f * log2(max(kept, 1e-3f)), estimate, estimated);
}

/// Share of a light that other parts of the body and guided curves let through to fur whose hull is at `open`, and as
/// high as `hull`, or to skin.
HWY_INLINE Real cast_light(const ShadowCaster& caster, Vec3 place, Vec3 open, Real hull, Vec3 normal) {
  if (!caster.depths || caster.edge == ShadowEdge::none) return 1.0f;
  const Real kept =
      caster.edge == ShadowEdge::penumbra ? past_body(caster, open, hull, normal) : past_edge(caster, place);
  return caster.curves ? kept * past_curves(caster, place) : kept;
}

}  // namespace pelage::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
