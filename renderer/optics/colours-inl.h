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
#include "renderer/optics/paint-inl.h"

HWY_BEFORE_NAMESPACE();
namespace pelage::HWY_NAMESPACE {

/// Four bytes, in [0, 1].
struct Texel {
  Real x, y, z, w;
};
HWY_INLINE Texel texel_of(Int word) { return {byte_of<0>(word), byte_of<1>(word), byte_of<2>(word), byte_of<3>(word)}; }

/// A volume about a surface, even between its cells and held at its sides.
HWY_INLINE Texel volume_at(const SurfaceVolume& volume, Vec3 place) {
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
  const Real none = 0.0f;
  Texel sum{none, none, none, none};
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
    const Texel texel = texel_of(gather(bytes, cell));
    sum.x += weight * texel.x, sum.y += weight * texel.y, sum.z += weight * texel.z, sum.w += weight * texel.w;
  }
  return sum;
}

/// The colour of a strand whose root is at `root` and which would be `base` without a pattern; `lightness` and `hue`
/// are its slow changes.
HWY_INLINE Vec3 pattern_colour(const PatternOptics& pattern, Vec3 root, Real lightness, Real hue, Vec3 base) {
  const Texel weights = volume_at(*pattern.volume, (root - Vec3(pattern.origin)) * Vec3(pattern.scale));
  const Real shade = 0.36f + 0.84f * pattern.over_lightness * luminance(base);
  Vec3 colour = mix(base, shade * Vec3(pattern.belly_colour), weights.x);
  colour = mix(colour, shade * Vec3(pattern.inner_colour), weights.y);
  colour = mix(colour, shade * Vec3(pattern.colour), weights.z);
  return colour * lightness * Vec3(1.0f + hue, 1.0f, 1.0f - hue);
}

/// Where the strands of a root gather on the surface. A strand goes to the side by less than its length.
struct Tuft {
  Vec3 to_middle;  // sizes
  Real inside, gather;
};
HWY_INLINE Tuft tuft_at(const TuftOptics& tufts, Vec3 root, Real length_of_fur) {
  const Texel texel = volume_at(*tufts.volume, (root - Vec3(tufts.origin)) * Vec3(tufts.scale));
  const Vec3 to_middle = (Vec3(texel.x, texel.y, texel.z) * 2.0f - Vec3(1.0f)) * tufts.longest;
  const Real radius = length(to_middle) / max(1.0f - texel.w, 0.05f);
  return {to_middle, texel.w, tufts.gather * min(1.0f, length_of_fur / max(radius, 1e-4f))};
}

/// A whole number of texels, on a periodic side.
HWY_INLINE Int wrapped(Int at, Int side) {
  const Int low = hn::IfThenElse(hn::Lt(at, whole(0)), hn::Add(at, side), at);
  return hn::IfThenElse(hn::Lt(low, side), low, hn::Sub(low, side));
}

/// The colour of an image at a place (v up), linear, between four texels of a level: the nearest for so much of the
/// picture's side as a pixel sees.
HWY_INLINE Vec3 image_colour(const BaseImages& images, Vec3 uv, Real pixel) {
  const auto* numbers = reinterpret_cast<const std::int32_t*>(images.levels.data());
  const auto largest = static_cast<float>(std::max(images.levels[0].width, images.levels[0].height));
  const Real lod = clamp(log2(pixel * largest) + 0.5f, 0.0f, static_cast<float>(images.levels.size()) - 1.0f);
  const Int level = hn::Mul(to_int(lod), whole(3));
  const Int width = gather(numbers, level), height = gather(numbers + 1, level), first = gather(numbers + 2, level);
  const Real u = uv.x - floor(uv.x), v = 1.0f - uv.y - floor(1.0f - uv.y);
  const Real x = u * to_real(width) - 0.5f, y = v * to_real(height) - 0.5f, px = x - floor(x), py = y - floor(y);
  const Int start = hn::Add(first, hn::Mul(hn::Mul(width, height), to_int(max(uv.z, 0.0f) + 0.5f)));
  Vec3 sum(0.0f);
  for (int k = 0; k < 4; ++k) {
    const Int at_x = wrapped(hn::Add(to_int(floor(x)), whole(k & 1)), width),
              at_y = wrapped(hn::Add(to_int(floor(y)), whole(k >> 1)), height);
    const Int word = gather(images.texels.data(), hn::Add(start, hn::Add(hn::Mul(at_y, width), at_x)));
    const auto channel = [&](Int byte) HWY_ATTR { return gather(images.linear.data(), hn::And(byte, whole(255))); };
    const Real weight = (k & 1 ? px : 1.0f - px) * (k & 2 ? py : 1.0f - py);
    sum += weight * Vec3(channel(word), channel(hn::ShiftRight<8>(word)), channel(hn::ShiftRight<16>(word)));
  }
  return select(uv.z < -0.5f, Vec3(1.0f), sum);
}

/// The model's own colour; `pixel` is what share of an image's side a pixel sees.
template <class Rows>
HWY_INLINE Vec3 model_colour(const FrameOptics& optics, int image, Rows rows, Real pixel) {
  const Vec3 colour = max(rows(image + 3), 0.0f);  // of vertices: negative where a sample lies outside its triangle
  return optics.images ? colour * image_colour(*optics.images, rows(image), pixel) : colour;
}

/// Hue from the model, lightness along the strand from the ramp; or the ramp alone; and markings over it. `row` and
/// `rows` read what varies over the surface; `pixel` is as in model_colour.
template <class Varyings, class Row, class Rows>
HWY_INLINE Vec3 strand_colour(const FrameOptics& optics, const Varyings& varyings, Vec3 strand, Row row, Rows rows,
                              Real pixel) {
  Vec3 colour = strand;
  if (varyings.image >= 0) {
    const Real lightness = luminance(strand) * (1 / optics.frame.tile.w);
    colour = model_colour(optics, varyings.image, rows, pixel) * (0.36f + 0.84f * lightness);
  }
  if (varyings.varied >= 0)
    colour =
        pattern_colour(optics.pattern, rows(varyings.root), row(varyings.varied), row(varyings.varied + 1), colour);
  return colour;
}

/// What is painted where rows are read.
template <class Varyings, class Row>
HWY_INLINE PaintedFields painted_fields(const Varyings& varyings, Row row) {
  if (varyings.paint < 0) return unpainted();
  const int at = varyings.paint;
  return {row(at), row(at + 1), row(at + 2), row(at + 3), row(at + 4), row(at + 5)};
}
template <class Varyings, class Row, class Rows>
HWY_INLINE PaintedColours painted_colours(const Varyings& varyings, Row row, Rows rows) {
  const int at = varyings.painted;
  return {rows(at), rows(at + 4), row(at + 3), row(at + 7)};
}

}  // namespace pelage::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
