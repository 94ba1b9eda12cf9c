// Light on fur for several pixels at once: what arrives, and what gets through. The twin of
// renderer/shaders/lighting.glsl, which has the sources of the formulas.
#if defined(PELAGE_OPTICS_LIGHT_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef PELAGE_OPTICS_LIGHT_INL_H_
#undef PELAGE_OPTICS_LIGHT_INL_H_
#else
#define PELAGE_OPTICS_LIGHT_INL_H_
#endif

#include "renderer/optics/frame_optics.h"
#include "renderer/optics/lanes-inl.h"
#include "renderer/optics/scattering-inl.h"

HWY_BEFORE_NAMESPACE();
namespace pelage::HWY_NAMESPACE {

struct Arriving {
  Vec3 to_light;  // unit
  Vec3 radiance;
};

HWY_INLINE Arriving light_at(const FrameOptics& optics, int i, Vec3 place) {
  const LightBlock& light = optics.frame.lights[static_cast<std::size_t>(i)];
  if (optics.far_lights) return {-Vec3(light.direction), Vec3(light.radiance)};
  const Vec3 apart = Vec3(light.position) - place;
  const Real square = max(dot(apart, apart), static_cast<float>(min_light_square));
  const bool point = light.direction.w > 0.5f;
  const Vec3 to_light = point ? apart * (1.0f / sqrt(square)) : -Vec3(light.direction);
  const Real falloff = point ? min(1.0f / square, static_cast<float>(max_light_falloff)) : Real(1.0f);
  const Real inside = -dot(to_light, Vec3(light.direction));
  const float edge = light.position.w, width = std::max(light.radiance.w - edge, 1e-6f);
  return {to_light, Vec3(light.radiance) * (falloff * clamp((inside - edge) * (1 / width), 0.0f, 1.0f))};
}

/// Share of the light that a strand of that colour stops, by `part` of its thickness; `self_shadow` is the look's.
HWY_INLINE Vec3 stopped_by_strand(Vec3 colour, float part, float self_shadow) {
  return each(colour, [=](Real c) HWY_ATTR {
    return 1.0f - exp2(-2.0f * 1.442695f * part * self_shadow * (1.0f - 0.82f * sqrt(clamp(c, 0.0f, 1.0f))));
  });
}

/// How far a ray goes through the fur to get out of it, over the height above where it sets out.
HWY_INLINE Real way_out(Real height, Real facing) {
  const Real roundness = 0.2f * (1.0f - height) + 0.01f;
  return 2.0f / (facing + sqrt(facing * facing + roundness));
}

/// Strands that a ray crosses on its way out, of `above` that one at 45 degrees to upright fur would cross.
HWY_INLINE Real strands_crossed(Real above, Real way, Vec3 tangent, Vec3 direction) {
  const float spread = 0.08f;  // strands of one place differ in direction
  const Real along = dot(tangent, direction);
  return above * sqrt(1.0f - (1.0f - spread) * min(along * along, 1.0f)) * way;
}

/// Colour of the fur above a height over the colour there.
HWY_INLINE Vec3 colour_above(const FrameBlock& frame, Real height) {
  const Int slice = to_int(clamp(height * static_cast<float>(slice_count), 0.0f, slice_count - 1.0f));
  const Quad colour = gather_quad(&frame.colour_above[0].x, hn::ShiftLeft<2>(slice));
  return {colour.real(0), colour.real(1), colour.real(2)};
}

/// Share of the light from all around that gets to a height. `stopped` is for a part of .6.
HWY_INLINE Vec3 ambient_share(const FrameBlock& frame, Real height, Real above, Vec3 stopped) {
  const float known = std::min(frame.exponents.w, 1.0f), floor_share = frame.weights.w;
  return each(stopped, [=](Real s) HWY_ATTR {
    const Real a = above * s;
    const Real reached = (1.0f + a) / (1.0f + a * (2.5707963f + a * (1.21f + a * 0.5f)));
    return mix(Real(floor_share), Real(1.0f), mix(height, reached, known));
  });
}

/// Light from all around on a surface with that normal; 1 for a white surrounding.
HWY_INLINE Vec3 environment_light(const FrameOptics& optics, Vec3 n) {
  const auto& e = optics.frame.environment;
  Vec3 sum = Vec3(0.28209479f * glm::vec3(e[0]));
  sum += 0.48860251f * (n.y * Vec3(e[1]) + n.z * Vec3(e[2]) + n.x * Vec3(e[3]));
  sum += 1.09254843f * (n.x * n.y * Vec3(e[4]) + n.y * n.z * Vec3(e[5]) + n.x * n.z * Vec3(e[7]));
  sum += 0.31539157f * (3.0f * n.z * n.z - 1.0f) * Vec3(e[6]);
  sum += 0.54627422f * (n.x * n.x - n.y * n.y) * Vec3(e[8]);
  return max(sum, 0.0f);
}

struct Fibre {
  Vec3 place;
  Vec3 normal, tangent, to_camera;
  Vec3 colour;   // C
  Vec3 crossed;  // colour of the fur above: colour_crossed of lighting.glsl
  Real height;   // s in [0, 1]
  Real above;    // strands over the place that a ray at 45 degrees to upright fur would cross
  Real strand;   // number of the strand in [0, 1]
  Shine shine;
};

/// What of a fibre's view all lights share.
struct FibreView {
  Real way, strands;  // out of the fur to the camera, and the strands on it
  Real widths;        // of the fur above
};

HWY_INLINE FibreView view_of(const FrameBlock& frame, const Fibre& fibre) {
  const Real way = way_out(fibre.height, dot(fibre.normal, fibre.to_camera));
  return {way, strands_crossed(fibre.above, way, fibre.tangent, fibre.to_camera),
          fibre.above * (1 / std::max(frame.counts.y, 1e-6f)) * max(dot(fibre.tangent, fibre.normal), 0.15f)};
}

}  // namespace pelage::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
