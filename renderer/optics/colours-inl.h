// The colour of a strand: from its coat, the model, the pattern. The twin of renderer/shaders/base_colour.glsl and
// pattern.glsl.
#if defined(PELAGE_OPTICS_COLOURS_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef PELAGE_OPTICS_COLOURS_INL_H_
#undef PELAGE_OPTICS_COLOURS_INL_H_
#else
#define PELAGE_OPTICS_COLOURS_INL_H_
#endif

#include "renderer/optics/frame_optics.h"
#include "renderer/optics/lanes-inl.h"

HWY_BEFORE_NAMESPACE();
namespace pelage::HWY_NAMESPACE {

/// Three bytes of a volume about a surface, in [0, 1], even between its cells and held at its sides.
HWY_INLINE Vec3 volume_at(const SurfaceVolume& volume, Vec3 place) {
  const auto* bytes = reinterpret_cast<const std::int32_t*>(volume.rgba.data());
  Int low[3];
  Real share[3];
  const Real at[3] = {place.x, place.y, place.z};
  for (int k = 0; k < 3; ++k) {
    const float last = static_cast<float>(volume.size[k] - 1);
    const Real cell = clamp(at[k] * static_cast<float>(volume.size[k]) - 0.5f, 0.0f, last);
    const Real below = min(floor(cell), std::max(last - 1, 0.0f));
    low[k] = to_int(below), share[k] = cell - below;
  }
  Vec3 sum(0.0f, 0.0f, 0.0f);
  for (int corner = 0; corner < 8; ++corner) {
    Int index[3];
    Real weight = 1.0f;
    for (int k = 0; k < 3; ++k) {
      const bool high = corner >> k & 1;
      index[k] = high ? hn::Min(hn::Add(low[k], whole(1)), whole(volume.size[k] - 1)) : low[k];
      weight *= high ? share[k] : 1.0f - share[k];
    }
    const Int cell =
        hn::Add(hn::Mul(hn::Add(hn::Mul(index[2], whole(volume.size.y)), index[1]), whole(volume.size.x)), index[0]);
    const Int word = gather(bytes, cell);
    sum += weight * Vec3(byte_of<0>(word), byte_of<1>(word), byte_of<2>(word));
  }
  return sum;
}

/// The colour of a strand whose root is at `root` and which would be `base` without a pattern; `lightness` and `hue`
/// are its slow changes.
HWY_INLINE Vec3 pattern_colour(const PatternOptics& pattern, Vec3 root, Real lightness, Real hue, Vec3 base) {
  const Vec3 weights = volume_at(*pattern.volume, (root - Vec3(pattern.origin)) * Vec3(pattern.scale));
  const Real shade = 0.36f + 0.84f * pattern.over_lightness * luminance(base);
  Vec3 colour = mix(base, shade * Vec3(pattern.belly_colour), weights.x);
  colour = mix(colour, shade * Vec3(pattern.inner_colour), weights.y);
  colour = mix(colour, shade * Vec3(pattern.colour), weights.z);
  return colour * lightness * Vec3(1.0f + hue, 1.0f, 1.0f - hue);
}

/// Hue from the model, lightness along the strand from the ramp; or the ramp alone; and markings over it. `row` and
/// `rows` read what varies over the surface.
template <class Varyings, class Row, class Rows>
HWY_INLINE Vec3 strand_colour(const FrameOptics& optics, const Varyings& varyings, Vec3 strand, Row row, Rows rows) {
  Vec3 colour = strand;
  if (varyings.image >= 0) {
    const Real lightness = luminance(strand) * (1 / optics.frame.tile.w);
    colour = max(rows(varyings.image + 3), 0.0f) * (0.36f + 0.84f * lightness);
  }
  if (varyings.varied >= 0)
    colour =
        pattern_colour(optics.pattern, rows(varyings.root), row(varyings.varied), row(varyings.varied + 1), colour);
  return colour;
}

}  // namespace pelage::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
