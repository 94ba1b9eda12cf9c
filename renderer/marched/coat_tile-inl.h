// Reading the coat: its texels about a place of the tile.
#if defined(PELAGE_MARCHED_COAT_TILE_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef PELAGE_MARCHED_COAT_TILE_INL_H_
#undef PELAGE_MARCHED_COAT_TILE_INL_H_
#else
#define PELAGE_MARCHED_COAT_TILE_INL_H_
#endif

#include "renderer/marched/slice_atlas.h"
#include "renderer/optics/colours-inl.h"
#include "renderer/optics/lanes-inl.h"

HWY_BEFORE_NAMESPACE();
namespace pelage::HWY_NAMESPACE {

/// Texels of a place on the periodic tile.
class TilePlace {
 public:
  HWY_INLINE TilePlace(const SliceAtlas& of, Int level_first, Int level_side, Int of_slice)
      : atlas(of), first(level_first), side(level_side), slice(of_slice) {}
  const SliceAtlas& atlas;
  Int first, side, slice;

  HWY_INLINE Int word(Int x, Int y) const {
    const Int last = hn::Sub(side, whole(1));
    const Int texel = hn::Add(hn::Mul(hn::And(y, last), side), hn::And(x, last));
    return hn::Add(first, hn::Add(hn::Mul(texel, whole(slice_count)), slice));
  }
  HWY_INLINE Int shape_word(Int x, Int y) const { return gather(atlas.shapes.data(), word(x, y)); }

  /// Between the four texels around the place, which lies at x, y texels; within half a 255th.
  HWY_INLINE Texel smooth_shape(Real x, Real y) const {
    const Real x0 = floor(x - 0.5f), y0 = floor(y - 0.5f);
    const Int left = to_int(x0), top = to_int(y0), right = hn::Add(left, whole(1)), bottom = hn::Add(top, whole(1));
    const Int a = shape_word(left, top), b = shape_word(right, top), c = shape_word(left, bottom),
              d = shape_word(right, bottom);
    const BytePairs px = weight_of(x - 0.5f - x0), py = weight_of(y - 0.5f - y0);
    const Int even = mixed(even_bytes(a), even_bytes(b), even_bytes(c), even_bytes(d), px, py);
    const Int odd = mixed(odd_bytes(a), odd_bytes(b), odd_bytes(c), odd_bytes(d), px, py);
    return {low_of(even), low_of(odd), high_of(even), high_of(odd)};
  }

 private:
  using PairTag = hn::Repartition<std::uint16_t, IntTag>;
  using BytePairs = hn::Vec<PairTag>;  // two numbers in each lane
  static constexpr PairTag pair_tag{};

  static HWY_INLINE BytePairs even_bytes(Int w) { return hn::BitCast(pair_tag, hn::And(w, whole(0x00ff00ff))); }
  static HWY_INLINE BytePairs odd_bytes(Int w) { return even_bytes(hn::ShiftRight<8>(w)); }
  /// 0 to 256 for a share in [0, 1), in both halves.
  static HWY_INLINE BytePairs weight_of(Real share) {
    const Int weight = to_int(share * 256.0f);
    return hn::BitCast(pair_tag, hn::Or(weight, hn::ShiftLeft<16>(weight)));
  }
  /// 256 times what lies between.
  static HWY_INLINE BytePairs between(BytePairs p, BytePairs q, BytePairs weight) {
    const BytePairs rest = hn::Sub(hn::Set(pair_tag, std::uint16_t{256}), weight);
    return hn::Add(hn::Mul(p, rest), hn::Mul(q, weight));
  }
  static HWY_INLINE Int mixed(BytePairs a, BytePairs b, BytePairs c, BytePairs d, BytePairs px, BytePairs py) {
    const BytePairs half = hn::Set(pair_tag, std::uint16_t{128});
    const BytePairs top = hn::ShiftRight<8>(hn::Add(between(a, b, px), half));
    const BytePairs bottom = hn::ShiftRight<8>(hn::Add(between(c, d, px), half));
    return hn::BitCast(int_tag, between(top, bottom, py));
  }
  static HWY_INLINE Real low_of(Int pair) { return to_real(hn::And(pair, whole(0xffff))) * (1.0f / 65280); }
  static HWY_INLINE Real high_of(Int pair) {
    return to_real(hn::And(hn::ShiftRight<16>(pair), whole(0xffff))) * (1.0f / 65280);
  }
};

/// Share of the optical depth about a place that belongs to strands whose number is below the density (strand_share of
/// paint_form.glsl): numbers cannot be filtered, so each of four texels counts as a whole.
HWY_INLINE Real strand_share(const TilePlace& place, Real x, Real y, Real density, Real sharp) {
  constexpr float finest_shared = 3;  // the level from which on texels hold several strands
  const Mask thinned = density < 1.0f, single = sharp < finest_shared;
  if (!any(thinned)) return 1.0f;
  if (!any(thinned & single)) return min(density, 1.0f);
  const Real x0 = floor(x - 0.5f), y0 = floor(y - 0.5f), px = x - 0.5f - x0, py = y - 0.5f - y0;
  Real whole_depth = 1e-6f, kept = 0.0f;
  for (int k = 0; k < 4; ++k) {
    const Int at_x = hn::Add(to_int(x0), whole(k & 1)), at_y = hn::Add(to_int(y0), whole(k >> 1));
    const Int word = place.word(at_x, at_y);
    const Real near = (k & 1 ? px : 1.0f - px) * (k & 2 ? py : 1.0f - py);
    const Real depth = near * byte_of<3>(gather(place.atlas.shapes.data(), word));
    whole_depth += depth;
    kept += select(byte_of<3>(gather(place.atlas.colours.data(), word)) < density, depth, 0.0f);
  }
  return select(thinned, select(single, kept / whole_depth, density), 1.0f);
}

}  // namespace pelage::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
