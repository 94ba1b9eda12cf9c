// What painted fields do to strands and their colours. The twin of renderer/shaders/paint_form.glsl and
// paint_light.glsl.
#if defined(PELAGE_OPTICS_PAINT_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef PELAGE_OPTICS_PAINT_INL_H_
#undef PELAGE_OPTICS_PAINT_INL_H_
#else
#define PELAGE_OPTICS_PAINT_INL_H_
#endif

#include <hwy/contrib/math/math-inl.h>

#include "renderer/optics/frame_optics.h"
#include "renderer/optics/gathering-inl.h"
#include "renderer/optics/scattering-inl.h"

HWY_BEFORE_NAMESPACE();
namespace pelage::HWY_NAMESPACE {

struct PaintedFields {
  Real density, width, wetness, bare, curl, clump;
  /// How much of the light fur keeps from what lies below it, over that of the coat.
  HWY_INLINE Real depth() const { return density * width; }
};

HWY_INLINE PaintedFields unpainted() { return {1.0f, 1.0f, 0.0f, 0.0f, 0.0f, 0.0f}; }

/// What is finer than pixels stays: `level` is that of the coat.
HWY_INLINE Gathering painted_clump(const PaintOptics& paint, const PaintedFields& fields, Vec2 tile, Real level) {
  const Real water = min(fields.wetness + paint.wetness, 1.0f) - paint.wetness;
  const Real fine = 1.0f - smoothstep(4.0f, 6.0f, level);
  const Real gather =
      static_cast<float>(max_clump_gather) * min(fields.clump + static_cast<float>(water_gathers) * water, 1.0f) * fine;
  const int side = paint.clump_side;
  const auto texel = [&](Real at)
                         HWY_ATTR { return hn::And(to_int(floor(at * static_cast<float>(side))), whole(side - 1)); };
  const Int word =
      hn::GatherIndex(int_tag, paint.clumps.data(), hn::Add(hn::Mul(texel(tile.y), whole(side)), texel(tile.x)));
  const Vec2 middle{byte_of<0>(word) * 2.0f - 1.0f, byte_of<1>(word) * 2.0f - 1.0f};
  return {middle * paint.clump_reach, byte_of<2>(word), gather * mix(0.5f, 1.0f, byte_of<3>(word))};
}

/// The circle that strands of a place run round: its radius over the length that a tile is made for, and where on it.
struct PaintedCurl {
  Real radius, phase;
  float turns;

  HWY_INLINE Real angle(Real s) const { return 6.2831853f * turns * s + phase; }
  HWY_INLINE Real grown(Real s) const { return radius * min(1.0f, 4.0f * s); }
};

HWY_INLINE PaintedCurl painted_curl(const PaintOptics& paint, const PaintedFields& fields, Vec2 tile) {
  const Real radius = max(min(paint.curl + fields.curl, static_cast<float>(max_curl)) - paint.curl, 0.0f);
  const auto wave = [](Real at, float off) HWY_ATTR { return Real(hn::Sin(float_tag, (6.2831853f * at + off).v)); };
  return {select(fields.curl > 0.0f, radius, 0.0f), 2.2f * (wave(tile.x, 0.7f) + wave(tile.y, 2.1f)), paint.curl_turns};
}

/// From the root at a height, and its change for a unit of height; both over the length that a tile is made for.
HWY_INLINE Vec2 curl_offset(const PaintedCurl& curl, Real s) {
  const Real angle = curl.angle(s), grown = curl.grown(s);
  return {grown * Real(hn::Cos(float_tag, angle.v)), grown * Real(hn::Sin(float_tag, angle.v))};
}
HWY_INLINE Vec2 curl_slope(const PaintedCurl& curl, Real s) {
  const Real angle = curl.angle(s), turning = curl.grown(s) * (6.2831853f * curl.turns);
  return {-turning * Real(hn::Sin(float_tag, angle.v)), turning * Real(hn::Cos(float_tag, angle.v))};
}

/// Paint at the root and the tip: times its cover, and the cover.
struct PaintedColours {
  Vec3 root, tip;
  Real root_cover, tip_cover;
};

struct Cover {
  Vec3 colour;  // times the share
  Real share;
};
HWY_INLINE Cover cover_at(const PaintedColours& paint, Real height) {
  return {mix(paint.root, paint.tip, height), mix(paint.root_cover, paint.tip_cover, height)};
}
HWY_INLINE Vec3 covered_by(const Cover& cover, Vec3 colour, Real lighter) {
  return colour * (1.0f - cover.share) + cover.colour * lighter;
}

/// As renderer/coat/strand_tile.h, for the water that is painted beyond the coat's own.
HWY_INLINE Real wetter(const PaintOptics& paint, Real wetness, float rise) {
  return (1.0f + rise * min(paint.wetness + wetness, 1.0f)) * (1 / (1 + rise * paint.wetness));
}
HWY_INLINE Vec3 colour_wetted(const PaintOptics& paint, Real wetness, Vec3 colour) {
  const Real power = wetter(paint, wetness, static_cast<float>(water_darkens));
  return each(colour, [=](Real c) HWY_ATTR { return select(c > 0.0f, pow(c, power), 0.0f); });
}
HWY_INLINE Shine shine_of(const PaintOptics& paint, Real wetness) {
  return {wetter(paint, wetness, static_cast<float>(water_shines)),
          wetter(paint, wetness, static_cast<float>(water_sharpens))};
}

}  // namespace pelage::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
