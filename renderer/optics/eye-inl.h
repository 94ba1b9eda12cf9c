// An eye for several pixels at once: where rays meet its ball, cornea and lids, and what light comes back.
// All places are in the eye's frame.
#if defined(PELAGE_OPTICS_EYE_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef PELAGE_OPTICS_EYE_INL_H_
#undef PELAGE_OPTICS_EYE_INL_H_
#else
#define PELAGE_OPTICS_EYE_INL_H_
#endif

#include <cmath>

#include "renderer/optics/iris-inl.h"

HWY_BEFORE_NAMESPACE();
namespace pelage::HWY_NAMESPACE {

/// The white: vessels redden it away from the iris, and light wraps around it, red the furthest.
HWY_INLINE Vec3 sclera_colour(const EyeView& view, Vec3 place) {
  const EyeEntry& eye = view.eye;
  const Real back = acos(clamp(place.z, -1.0f, 1.0f)) - std::asin(std::clamp(eye.up.w, 0.0f, 1.0f));
  const Texel tissue = tissue_texel(*view.optics.eyes.tissues, turn_of(eye, place.x, place.y),
                                    clamp(back * (1 / 1.2f), 0.0f, 1.0f), view.pixel * (iris_map_height / 1.2f));
  const Real lid = 1.0f - smoothstep(0.0f, 0.45f, lid_opening(eye, unit_or_zero(place)));
  const Real red = clamp(0.75f * lid + 0.5f * smoothstep(0.15f, 1.0f, back), 0.0f, 1.0f);
  const Vec3 white(1.0f);
  Vec3 colour = Vec3(eye.sclera) * mix(white, Vec3(0.80f, 0.42f, 0.36f), 0.6f * red);
  colour *= mix(white, Vec3(0.72f, 0.25f, 0.20f), 0.65f * tissue.w * (0.35f + 0.65f * red));
  return colour * (1.0f - 0.9f * eye.iris.w * (1.0f - smoothstep(0.0f, 0.16f, back)));
}

HWY_INLINE Vec3 sclera_light(const EyeView& view, Vec3 place, Vec3 normal) {
  Vec3 sum(open_sky(view.eye, place) * view.ambient());
  for (int i = 0; i < view.lights; ++i) {
    const Arriving light = light_on_eye(view, i, place);
    const Real cosine = dot(normal, light.to_light);
    const auto wrapped = [&](float wrap) HWY_ATTR { return max((cosine + wrap) * (1 / (1 + wrap)), 0.0f); };
    sum += light.radiance * Vec3(wrapped(0.45f), wrapped(0.28f), wrapped(0.22f)) *
           past_lids(view.eye, place, light.to_light);
  }
  return sclera_colour(view, place) * sum;
}

/// What the head's surroundings send along a reflected ray: a soft sky, a darker ground, and fur beside the eye.
HWY_INLINE Vec3 surroundings_along(const EyeView& view, Vec3 way, Vec3 place) {
  const EyeEntry& eye = view.eye;
  const Real height = eye.right.y * way.x + eye.up.y * way.y + eye.forward.y * way.z;
  const Vec3 facing = eye.lid_right.w == 0 ? Vec3(0.0f, 0.0f, 1.0f) : Vec3(eye.lid_facing);
  const Real share = mix(0.30f, 1.15f, smoothstep(-0.25f, 0.75f, height)) *
                     mix(0.08f, 1.0f, smoothstep(-0.15f, 0.55f, dot(way, facing)));
  return Vec3(view.optics.eyes.block.surroundings) * (share * past_lids(eye, place, way));
}

/// Unpolarised Fresnel reflectance, as in renderer/eye/optics.cpp.
HWY_INLINE Real eye_reflectance(const EyeEntry& eye, Real cosine) {
  const float index = eye.position.w, square = index * index;
  const Real c = clamp(cosine, 0.0f, 1.0f), inside = sqrt(max(square - 1.0f + c * c, 0.0f)), both = inside + c;
  const Real across = (c - inside) / max(both, 1e-6f), along = (square * c - inside) / max(square * c + inside, 1e-6f);
  return select(both <= 1e-6f, 0.0f, 0.5f * (across * across + along * along));
}

/// The tear film: every light is a soft disc whose size wetness sets; its energy stays.
HWY_INLINE Vec3 light_in_tear_film(const EyeView& view, Vec3 place, Vec3 normal) {
  const float wetness = view.eye.sclera.w;
  const float disc = 0.5f + wetness * (0.11f - 0.5f);  // radians
  const float gain = 1 / (std::sin(disc) * std::sin(disc));
  const Real cosine = dot(view.along, normal);
  const Vec3 way = view.along - 2.0f * min(cosine, 0.0f) * normal;
  Vec3 sum = surroundings_along(view, way, place);
  for (int i = 0; i < view.lights; ++i) {
    const Arriving light = light_on_eye(view, i, place);
    const Real off = acos(clamp(dot(way, light.to_light), -1.0f, 1.0f));
    const Real shown = 1.0f - smoothstep(0.85f * disc, 1.15f * disc, off);
    if (any(shown > 0.0f)) sum += light.radiance * (gain * shown * past_lids(view.eye, place, light.to_light));
  }
  return sum * (eye_reflectance(view.eye, -cosine) * (0.35f + 0.65f * wetness));
}

/// How near the edge of the lids a place is, where they are moist.
HWY_INLINE Real lid_margin(const EyeView& view, Vec3 normal) {
  return 1.0f - smoothstep(0.02f, 0.14f, -lid_opening(view.eye, normal));
}
HWY_INLINE Vec3 lid_colour(const EyeView& view, Real margin) {
  const Vec3 lid(view.eye.lid);
  return mix(lid, lid * Vec3(0.7f, 0.55f, 0.55f), margin);
}

HWY_INLINE Vec3 lid_light(const EyeView& view, Vec3 place) {
  const Vec3 normal = unit_or_zero(place);
  const Real margin = lid_margin(view, normal);
  const Vec3 colour = lid_colour(view, margin);
  Vec3 sum = colour * view.ambient();
  for (int i = 0; i < view.lights; ++i) {
    const Arriving light = light_on_eye(view, i, place);
    const Vec3 middle = unit_or_zero(light.to_light - view.along);
    const Real gloss =
        mix(0.03f, 0.25f, margin) * pow(clamp(dot(normal, middle), 1e-12f, 1.0f), mix(10.0f, 40.0f, margin));
    sum += light.radiance * (colour + Vec3(gloss)) * max(dot(normal, light.to_light), 0.0f);
  }
  return sum;
}

/// 1 on the cornea, 0 on the white.
HWY_INLINE Real cornea_share(const EyeView& view, Vec3 place) {
  const float radius = view.iris_radius();
  const Real soft = max(0.04f * radius, view.pixel);
  const Real off = sqrt(place.x * place.x + place.y * place.y);
  return select(place.z > 0.0f, 1.0f - smoothstep(radius - soft, radius + soft, off), 0.0f);
}

/// Of ball and cornea; it never turns away from the ray.
HWY_INLINE Vec3 eyeball_normal(const EyeView& view, Vec3 place, Real cornea) {
  const Vec3 bulged = unit_or_zero(place - Vec3(0.0f, 0.0f, view.eye.cornea.x));
  const Vec3 normal = unit_or_zero(mix(unit_or_zero(place), bulged, cornea));
  const Real cosine = dot(normal, view.along);
  return select(cosine > -1e-3f, unit_or_zero(normal - view.along * (cosine + 1e-3f)), normal);
}

HWY_INLINE Vec3 eyeball_light(const EyeView& view, Vec3 place) {
  const Real cornea = cornea_share(view, place);
  const Vec3 normal = eyeball_normal(view, place, cornea);
  Vec3 seen(0.0f);
  if (any(cornea < 1.0f)) seen = sclera_light(view, place, normal);
  if (any(cornea > 0.0f)) seen = mix(seen, iris_light(view, place, normal), cornea);
  const Real kept = 1.0f - eye_reflectance(view.eye, -dot(view.along, normal));
  const Real opening = lid_opening(view.eye, unit_or_zero(place));
  const Real shaded = mix(0.30f, 1.0f, smoothstep(0.0f, 0.30f, opening));  // by lids and lashes close by
  return shaded * (seen * kept + light_in_tear_film(view, place, normal));
}

/// Where rays enter a ball.
struct BallHit {
  Vec3 place;
  Real covered;  // share of the pixel, softened over one pixel
};

/// Of a ball on the axis. Taken from a place of the ray close by, so that nothing is lost far from the eye; where it
/// misses by less than a pixel, the place on the silhouette.
HWY_INLINE BallHit enter_ball(Vec3 close_by, Vec3 along, Real pixel, float centre, float radius) {
  const Vec3 middle(0.0f, 0.0f, centre), off = close_by - middle, nearest = off - along * dot(off, along);
  const Real square = dot(nearest, nearest), inner = radius * radius - square;
  const Vec3 entered = nearest - along * sqrt(max(inner, 0.0f)),
             beside = nearest * (radius / sqrt(max(square, 1e-12f)));
  return {select(inner > 0.0f, entered, beside) + middle, clamp((radius - sqrt(square)) / pixel + 0.5f, 0.0f, 1.0f)};
}

/// What rays meet of an eye.
struct EyeHit {
  Mask there;
  Vec3 ball, lid;      // places
  Vec3 along;          // of the ray, unit
  Real pixel;          // its size at the eye, radii
  Real open, covered;  // share of the ball that is seen, share of the pixel
  Real shut;           // share of that which lids hide
  Vec3 nearest;        // of the two places
};

/// How far rays go until they enter the box around an eye, where the shader takes the size of a pixel.
HWY_INLINE Real way_to_box(const EyeEntry& eye, const glm::vec3& viewer, Vec3 along) {
  const float side = 1.02f * lid_radius, top = 1.02f * std::max(lid_radius, eye.cornea.x + eye.cornea.y);
  const auto enter = [](Real step, float from, float high, float low) HWY_ATTR {
    const Real to = select(step > 0.0f, low - from, high - from);
    return select(abs(step) > 1e-9f, to / step, -1e30f);
  };
  return max(enter(along.x, viewer.x, side, -side),
             max(enter(along.y, viewer.y, side, -side), enter(along.z, viewer.z, top, -side)));
}

/// `viewer` is in radii; `way` in the eye's frame, of any length; `pixel_angle` of one pixel.
HWY_INLINE EyeHit meet_eye(const EyeEntry& eye, const glm::vec3& viewer, Vec3 way, float pixel_angle) {
  EyeHit hit;
  hit.along = unit(way);
  const Vec3 from(viewer), close_by = from - hit.along * dot(from, hit.along);
  const Real middle = length(close_by - from), before = way_to_box(eye, viewer, hit.along);
  hit.pixel = max(pixel_angle * clamp(before, middle - 2.0f, middle), 1e-6f);
  const BallHit ball = enter_ball(close_by, hit.along, hit.pixel, 0, 1);
  const BallHit dome = enter_ball(close_by, hit.along, hit.pixel, eye.cornea.x, eye.cornea.y);
  const BallHit lid = enter_ball(close_by, hit.along, hit.pixel, 0, lid_radius);
  const Mask over = (dome.covered > 0.0f) & ((ball.covered <= 0.0f) | (dot(dome.place - ball.place, hit.along) < 0.0f));
  hit.ball = select(over, dome.place, ball.place), hit.lid = lid.place;
  hit.open = max(ball.covered, dome.covered);
  const bool lids = eye.lid_right.w != 0 && glm::length(viewer) > lid_radius;
  const Real half = 0.5f * hit.pixel;
  hit.shut = lids ? 1.0f - smoothstep(-half, half, lid_opening(eye, unit_or_zero(lid.place))) : Real(0.0f);
  hit.covered = mix(hit.open, lid.covered, hit.shut);
  hit.nearest = select(hit.shut > 0.5f, hit.lid, hit.ball);
  hit.there =
      (hit.covered > 0.0f) & (dot(hit.nearest - from, hit.along) > 0.0f);  // nor behind the camera, nor around it
  return hit;
}

/// Light of what is met, of as many lights; more than a half float holds would mix badly on the GPU too.
HWY_INLINE Vec3 eye_light(const FrameOptics& optics, const EyeEntry& eye, const EyeHit& hit, int lights) {
  const EyeView view{optics, eye, hit.along, hit.pixel, lights};
  const Mask ball = hit.there & (hit.shut < 1.0f) & (hit.open > 0.0f), lid = hit.there & (hit.shut > 0.0f);
  Vec3 light(0.0f);
  if (any(ball)) light = select(ball, eyeball_light(view, hit.ball), light);
  if (any(lid)) light = select(lid, mix(light, lid_light(view, hit.lid), hit.shut), light);
  return clamp(light, 0.0f, 6e4f);
}

/// The surface of what is met.
struct EyeSurface {
  Vec3 place, normal, albedo;  // in the world
};

HWY_INLINE EyeSurface eye_surface(const FrameOptics& optics, const EyeEntry& eye, const EyeHit& hit) {
  const EyeView view{optics, eye, hit.along, hit.pixel, 0};
  const Real cornea = cornea_share(view, hit.ball);
  const Vec3 ball_normal = eyeball_normal(view, hit.ball, cornea), lid_normal = unit_or_zero(hit.lid);
  const Vec2 at = behind_cornea(view, hit.ball, ball_normal).bottom;
  const Real edge = pupil_edge(eye, at), there = smoothstep(-hit.pixel, hit.pixel, length(at) - edge);
  const Texel tissue = iris_tissue(view, at, edge);
  const Vec3 ball = mix(sclera_colour(view, hit.ball), tissue_colour(eye, tissue) * (there * tissue.x), cornea);
  return {Vec3(eye.position) + out_of_eye_frame(eye, hit.nearest) * eye.right.w,
          out_of_eye_frame(eye, select(hit.shut > 0.5f, lid_normal, ball_normal)),
          mix(ball, lid_colour(view, lid_margin(view, lid_normal)), hit.shut)};
}

}  // namespace pelage::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
