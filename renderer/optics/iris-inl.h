// What is seen through the cornea of an eye, for several pixels at once: the iris behind it, marched or flat. All
// places are in the eye's frame.
#if defined(PELAGE_OPTICS_IRIS_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef PELAGE_OPTICS_IRIS_INL_H_
#undef PELAGE_OPTICS_IRIS_INL_H_
#else
#define PELAGE_OPTICS_IRIS_INL_H_
#endif

#include "renderer/eye/optics.h"
#include "renderer/optics/colours-inl.h"
#include "renderer/optics/light-inl.h"

HWY_BEFORE_NAMESPACE();
namespace pelage::HWY_NAMESPACE {

/// Angles within 3e-8 radians (Abramowitz and Stegun 4.4.49 and 4.4.46).
HWY_INLINE Real atan2(Real y, Real x) {
  const Real across = abs(x), up = abs(y), t = min(across, up) / max(max(across, up), 1e-30f), t2 = t * t;
  Real p = 0.0028662257f;
  for (const float factor : {-0.0161657367f, 0.0429096138f, -0.0752896400f, 0.1065626393f, -0.1420889944f,
                             0.1999355085f, -0.3333314528f, 1.0f})
    p = mul_add(p, t2, factor);
  Real angle = p * t;
  angle = select(up > across, 1.57079633f - angle, angle);
  angle = select(x < 0.0f, 3.14159265f - angle, angle);
  return select(y < 0.0f, -angle, angle);
}
HWY_INLINE Real acos(Real cosine) {
  const Real x = min(abs(cosine), 1.0f);
  Real p = -0.0012624911f;
  for (const float factor :
       {0.0066700901f, -0.0170881256f, 0.0308918810f, -0.0501743046f, 0.0889789874f, -0.2145988016f, 1.5707963050f})
    p = mul_add(p, x, factor);
  const Real angle = p * sqrt(1.0f - x);
  return select(cosine < 0.0f, 3.14159265f - angle, angle);
}

/// An eye as some rays meet it.
struct EyeView {
  const FrameOptics& optics;
  const EyeEntry& eye;
  Vec3 along;  // of the rays, unit
  Real pixel;  // its size at the eye, radii
  int lights;  // that light it, of the frame's

  HWY_INLINE float iris_radius() const { return eye.up.w; }
  HWY_INLINE float ambient() const { return optics.frame.weights.x; }
};

HWY_INLINE Vec3 in_eye_frame(const EyeEntry& eye, Vec3 v) {
  return {dot(Vec3(eye.right), v), dot(Vec3(eye.up), v), dot(Vec3(eye.forward), v)};
}
HWY_INLINE Vec3 out_of_eye_frame(const EyeEntry& eye, Vec3 v) {
  return Vec3(eye.right) * v.x + Vec3(eye.up) * v.y + Vec3(eye.forward) * v.z;
}

/// What a light brings to a place of the eye.
HWY_INLINE Arriving light_on_eye(const EyeView& view, int i, Vec3 place) {
  const Vec3 in_world = Vec3(view.eye.position) + out_of_eye_frame(view.eye, place) * view.eye.right.w;
  const Arriving light = FrameLight(view.optics).light_at(static_cast<Index>(i), in_world);
  return {in_eye_frame(view.eye, light.to_light), light.radiance};
}

/// The angle to the edge of the lids, above 0 where they are open.
HWY_INLINE Real lid_opening(const EyeEntry& eye, Vec3 direction) {
  if (eye.lid_right.w == 0) return 10.0f;
  const Real across = dot(Vec3(eye.lid_right), direction), up = dot(Vec3(eye.lid_up), direction),
             forward = dot(Vec3(eye.lid_facing), direction);
  const Real x = atan2(across, forward) * (1 / eye.lid_right.w),
             y = atan2(up, sqrt(across * across + forward * forward));
  const Real narrowing = 1.0f - x * x;
  return min(eye.lid_up.w * narrowing - y, y + eye.lid_facing.w * narrowing);
}

inline constexpr float lid_radius = 1.07f;

/// Share of the light from a direction that the lids let through to a place under them.
HWY_INLINE Real past_lids(const EyeEntry& eye, Vec3 place, Vec3 to_light) {
  if (eye.lid_right.w == 0) return 1.0f;
  const Real along = dot(place, to_light), apart = lid_radius * lid_radius - dot(place, place);
  const Real path = sqrt(max(along * along + apart, 0.0f)) - along;
  const Real share = smoothstep(-0.10f, 0.12f, lid_opening(eye, unit_or_zero(place + to_light * path)));
  return select(apart <= 0.0f, 1.0f, share);
}

HWY_INLINE Real open_sky(const EyeEntry& eye, Vec3 place) {
  return mix(0.22f, 1.0f, smoothstep(-0.05f, 0.55f, lid_opening(eye, unit_or_zero(place))));
}

/// Into an index of 1 or more light always goes.
HWY_INLINE Vec3 refracted(const EyeEntry& eye, Vec3 along, Vec3 normal) {
  const float eta = 1 / eye.position.w;
  const Real cosine = clamp(-dot(along, normal), 0.0f, 1.0f);
  return along * eta + (eta * cosine - sqrt(max(1.0f - eta * eta * (1.0f - cosine * cosine), 0.0f))) * normal;
}

/// Even between the four texels about a place in [0, 1], each of them four bytes; the sides of a row meet.
HWY_INLINE Texel tissue_of_level(const TissueLevels& tissues, Int level, Real around, Real along) {
  const Int width = hn::Shr(whole(iris_map_width), level), height = hn::Shr(whole(iris_map_height), level);
  const Int first = gather(tissues.first.data(), level), last_row = hn::Sub(height, whole(1));
  const Real x = around * to_real(width) - 0.5f, y = clamp(along * to_real(height) - 0.5f, 0.0f, to_real(last_row));
  const Real left = floor(x), top = floor(y), px = x - left, py = y - top;
  const Real none = 0.0f;
  Texel sum{none, none, none, none};
  for (int k = 0; k < 4; ++k) {
    const Int column = hn::And(hn::Add(to_int(left), whole(k & 1)), hn::Sub(width, whole(1)));
    const Int row = hn::Min(hn::Add(to_int(top), whole(k >> 1)), last_row);
    const Real weight = (k & 1 ? px : 1.0f - px) * (k & 2 ? py : 1.0f - py);
    const Texel texel = texel_of(gather(tissues.words.data(), hn::Add(first, hn::Add(hn::Mul(row, width), column))));
    sum.x += weight * texel.x, sum.y += weight * texel.y, sum.z += weight * texel.z, sum.w += weight * texel.w;
  }
  return sum;
}

/// `pixel_rows`: rows of the map that a pixel covers.
HWY_INLINE Texel tissue_texel(const TissueLevels& tissues, Real around, Real along, Real pixel_rows) {
  const Real lod = clamp(log2(max(pixel_rows, 1.0f)), 0.0f, TissueLevels::count - 1.0f), finer = floor(lod);
  const Texel fine = tissue_of_level(tissues, to_int(finer), around, along);
  if (!any(lod > 0.0f)) return fine;
  const Int next = hn::Min(hn::Add(to_int(finer), whole(1)), whole(TissueLevels::count - 1));
  const Texel coarse = tissue_of_level(tissues, next, around, along);
  const Real share = lod - finer;
  return {mix(fine.x, coarse.x, share), mix(fine.y, coarse.y, share), mix(fine.z, coarse.z, share),
          mix(fine.w, coarse.w, share)};
}

/// Around the axis in turns, from the fibres' own beginning.
HWY_INLINE Real turn_of(const EyeEntry& eye, Real x, Real y) { return atan2(y, x) * 0.15915494f + eye.inner.w; }

HWY_INLINE Texel iris_tissue(const EyeView& view, Vec2 at, Real edge) {
  const Real room = max(view.iris_radius() - edge, 0.02f);
  const Real along = clamp((length(at) - edge) / room, 0.0f, 1.0f);
  return tissue_texel(*view.optics.eyes.tissues, turn_of(view.eye, at.x, at.y), along,
                      view.pixel * static_cast<float>(iris_map_height) / room);
}

/// Irradiance on the iris at a place, over that of a surface which faces the light.
HWY_INLINE Real caustic(const EyeView& view, Vec2 at, Vec3 to_light) {
  constexpr float last_angle = caustic_angles - 1, last_texel = caustic_texels - 1;
  const Real angle = acos(clamp(to_light.z, -1.0f, 1.0f)) * (last_angle / static_cast<float>(caustic_reach));
  const Real scale = 1.0f / sqrt(max(to_light.x * to_light.x + to_light.y * to_light.y, 1e-12f));
  const Real from_x = to_light.x * scale, from_y = to_light.y * scale;
  const auto texel_at = [&](Real turned) HWY_ATTR {
    const float texels = caustic_texels;
    return clamp((turned * (0.5f / view.iris_radius()) + 0.5f) * texels - 0.5f, 0.0f, last_texel);
  };
  const Real x = texel_at(at.x * from_x + at.y * from_y), y = texel_at(from_x * at.y - from_y * at.x);
  const Real left = min(floor(x), last_texel - 1), top = min(floor(y), last_texel - 1);
  const Real layer = clamp(floor(angle), 0.0f, last_angle - 1);
  const Int texel = to_int(((view.eye.pupil.w + layer) * float{caustic_texels} + top) * float{caustic_texels} + left);
  const Real px = x - left, py = y - top;
  const auto sample = [&](int above) HWY_ATTR {
    const float* first = view.optics.eyes.caustics.data() + above * caustic_texels * caustic_texels;
    return mix(mix(gather(first, texel), gather(first + 1, texel), px),
               mix(gather(first + caustic_texels, texel), gather(first + caustic_texels + 1, texel), px), py);
  };
  return select(angle < last_angle, mix(sample(0), sample(1), angle - layer), 0.0f);
}

/// Distance from the axis to the pupil's edge in the direction of a place on the iris.
HWY_INLINE Real pupil_edge(const EyeEntry& eye, Vec2 at) {
  const float width = std::max(eye.pupil.x * eye.up.w, 1e-4f), height = std::max(eye.pupil.y * eye.up.w, 1e-4f);
  if (eye.pupil.z < 0.5f) return width;
  const Vec2 way = at * (1.0f / sqrt(max(at.x * at.x + at.y * at.y, 1e-12f)));
  const Real a = abs(way.x) * (1 / width), b = way.y * way.y * (1 / (height * height));
  const Real almond = 2.0f / (a + sqrt(a * a + 4.0f * b));  // |x| / w + (y / h)^2 = 1
  return 0.5f * (almond + 1.0f / sqrt(a * a + b));          // half way to an ellipse
}

/// Light that tissue sends back by the angle, over what it does to light that turns round (Henyey and Greenstein).
HWY_INLINE Real scattered_by_tissue(Real cosine) {
  const float g = 0.2f, turned = 1 + g;
  const Real share = turned * turned / (1.0f + g * g - 2.0f * g * cosine);
  return share * sqrt(share);
}

struct IrisLight {
  Vec3 arriving[max_lights];  // irradiance on the iris
  Real rising[max_lights];    // cosine of the light inside
  Real scattered[max_lights];
  Vec3 sky;
  Vec3 whole;  // of all lights and the sky
};

HWY_INLINE IrisLight light_on_iris(const EyeView& view, Vec3 surface, Vec3 normal, Vec3 inside, Vec2 at) {
  IrisLight lights;
  lights.sky = Vec3(open_sky(view.eye, surface) * view.ambient()), lights.whole = lights.sky;
  for (int i = 0; i < view.lights; ++i) {
    const Arriving light = light_on_eye(view, i, surface);
    lights.arriving[i] =
        light.radiance * (caustic(view, at, light.to_light) * past_lids(view.eye, surface, light.to_light));
    const Vec3 facing = select(dot(light.to_light, normal) > 0.0f, normal, light.to_light);
    const Vec3 way = refracted(view.eye, -light.to_light, facing);
    lights.rising[i] = max(-way.z, 0.15f);
    lights.scattered[i] = scattered_by_tissue(-dot(way, inside));
    lights.whole += lights.arriving[i];
  }
  return lights;
}

HWY_INLINE Vec3 tissue_colour(const EyeEntry& eye, const Texel& tissue) {
  return mix(Vec3(eye.iris), Vec3(eye.inner), tissue.z);
}

/// A flat or once shifted iris: all of its light comes from one place.
HWY_INLINE Vec3 flat_iris(const EyeView& view, Vec2 at, const IrisLight& lights) {
  const Real edge = pupil_edge(view.eye, at), soft = max(view.pixel, 0.01f);
  const Texel tissue = iris_tissue(view, at, edge);
  return lights.whole * tissue_colour(view.eye, tissue) *
         (tissue.x * 1.5f * smoothstep(-soft, soft, length(at) - edge));
}

/// What a step through tissue sends back of the light that falls on it, over what thick tissue does: scattered once,
/// with the light's way in from above the step and through it, and the ray's way through it. Steps of any size add up
/// to 1.
HWY_INLINE Real sent_back(Real above, Real thick, Real slant, Real rising) {
  const Real over = 1.0f / rising;
  return exp(-above * over) * (1.0f - exp(-thick * (slant + over)));
}

/// One step of a march through the iris.
struct IrisStep {
  Real below, above, thick;  // height of the tissue over the step, optical depth above it and in it
  Real slant;
};

HWY_INLINE Vec3 light_of_step(const EyeView& view, const IrisLight& lights, const IrisStep& step, const Texel& tissue) {
  Vec3 light = lights.sky * sent_back(step.above, step.thick, step.slant, 2.0f);
  for (int i = 0; i < view.lights; ++i) {
    light +=
        lights.arriving[i] * (lights.scattered[i] * sent_back(step.above, step.thick, step.slant, lights.rising[i]));
  }
  const Vec3 colour = tissue_colour(view.eye, tissue);
  return light * mix(colour, colour * colour, clamp(step.below, 0.0f, 1.0f)) * (tissue.x * 1.5f);
}

/// Subsurface texture mapping (Francois et al. 2006): ray marching through the iris. Height says where tissue is; it
/// scatters once, and what lies deeper is darker and more saturated. Below it is the pigment.
HWY_INLINE Vec3 marched_iris(const EyeView& view, Vec2 top, Vec2 bottom, Real slant, const IrisLight& lights) {
  constexpr float density = 7;  // optical depth of the whole relief
  const int steps = view.optics.eyes.steps;
  const float share = 1 / static_cast<float>(steps);
  Vec3 sum(0.0f);
  Real passed = 1.0f;
  for (int k = 0; k < steps && any(passed > 0.02f); ++k) {
    const float depth = (static_cast<float>(k) + 0.5f) * share;
    const Vec2 at{mix(top.x, bottom.x, depth), mix(top.y, bottom.y, depth)};
    const Real edge = pupil_edge(view.eye, at);
    const Texel tissue = iris_tissue(view, at, edge);
    IrisStep step;
    step.below = tissue.y - (1.0f - depth), step.slant = slant;
    step.thick = density * min(max(step.below + 0.5f * share, 0.0f), share);
    step.above = density * max(step.below - 0.5f * share, 0.0f);
    const Real there = select(passed > 0.02f, smoothstep(-view.pixel, view.pixel, length(at) - edge), 0.0f);
    if (!any(step.thick * there > 0.0f)) continue;
    sum += light_of_step(view, lights, step, tissue) * (passed * there);
    passed *= 1.0f - there * (1.0f - exp(-step.thick * slant));
  }
  const Vec3 colour(view.eye.iris);
  const Real seen = smoothstep(-view.pixel, view.pixel, length(bottom) - pupil_edge(view.eye, bottom));
  return sum + lights.whole * colour * colour * (0.25f * passed * seen);
}

/// Where the ray that enters the cornea at a place meets the plane of the iris.
struct BehindCornea {
  Vec3 inside;  // its way, unit
  Real over;    // way over depth
  Vec2 bottom;
};

HWY_INLINE BehindCornea behind_cornea(const EyeView& view, Vec3 place, Vec3 normal) {
  BehindCornea behind;
  behind.inside = view.optics.eyes.steps == 0 ? Vec3(0.0f, 0.0f, -1.0f) : refracted(view.eye, view.along, normal);
  behind.over = 1.0f / max(-behind.inside.z, 0.05f);
  const Real fallen = max(place.z - view.eye.cornea.z, 0.0f) * behind.over;
  behind.bottom = {place.x + behind.inside.x * fallen, place.y + behind.inside.y * fallen};
  return behind;
}

/// What is seen through the cornea at a place on it.
HWY_INLINE Vec3 iris_light(const EyeView& view, Vec3 place, Vec3 normal) {
  const EyeEntry& eye = view.eye;
  const int steps = view.optics.eyes.steps;
  const float radius = view.iris_radius();
  const BehindCornea behind = behind_cornea(view, place, normal);
  const Vec3 inside = behind.inside;
  const Real over = behind.over;
  Vec2 bottom = behind.bottom;
  const Vec2 top = bottom - Vec2{inside.x, inside.y} * (eye.cornea.w * over);
  const Real reach = length(bottom);
  bottom = bottom * min(1.0f, radius / max(reach, 1e-6f));
  const Real wall = steps == 0 ? Real(0.0f) : smoothstep(0.97f, 1.04f, reach * (1 / radius));  // side of the chamber
  const IrisLight lights = light_on_iris(view, place, normal, inside, bottom);
  const Vec3 seen = steps <= 1 ? flat_iris(view, bottom, lights) : marched_iris(view, top, bottom, over, lights);
  const Real ring = eye.iris.w * smoothstep(0.72f, 0.98f, length(bottom) * (1 / radius));
  return mix(seen * (1.0f - 0.92f * ring), Vec3(eye.iris) * (0.03f * open_sky(eye, place)), wall);
}

}  // namespace pelage::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
