// Light of a strand's knots from that of its points, or of its neighbour's by their colours; a knot a lane.
#if defined(PELAGE_RASTER_HAND_ON_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef PELAGE_RASTER_HAND_ON_INL_H_
#undef PELAGE_RASTER_HAND_ON_INL_H_
#else
#define PELAGE_RASTER_HAND_ON_INL_H_
#endif

#include "renderer/raster/strand_light-inl.h"

HWY_BEFORE_NAMESPACE();
namespace pelage::HWY_NAMESPACE {

HWY_INLINE void store_halves(Real value, hwy::float16_t* to) {
  const hn::Rebind<hwy::float16_t, FloatTag> halves;
  hn::StoreU(hn::DemoteTo(halves, min(value, 65504.0f).v), halves, to);
}

HWY_INLINE void hand_on(const StrandSet& set, std::uint32_t id, std::uint32_t from, const float* light, PlacedKnot* knots,
                        int count) {
  static_assert(sizeof(hwy::float16_t) == sizeof(std::uint16_t));
  const int points = lit_points(set.segments);
  const Int numbers = hn::Iota(int_tag, 0);
  const auto row = [&](std::uint32_t strand, Int knot) HWY_ATTR {
    const auto* words = reinterpret_cast<const std::int32_t*>(set.colours.data());
    return unpacked_colour(gather(words + std::size_t{strand} * static_cast<std::size_t>(set.segments + 1), knot));
  };
  for (int k = 0; k < count; k += lane_count) {
    const Real place = min(to_real(hn::Add(numbers, whole(k))), static_cast<float>(count - 1));
    const Int knot = to_int(mul_add(place, static_cast<float>(set.segments) / static_cast<float>(count - 1), 1e-3f));
    const Real at = to_real(knot) * (static_cast<float>(points - 1) / static_cast<float>(set.segments));
    const Real low = min(floor(at), static_cast<float>(points - 2)), part = at - low;
    const Int first = to_int(3.0f * low);
    const auto channel = [&](int c) HWY_ATTR { return mix(gather(light + c, first), gather(light + c + 3, first), part); };
    Vec3 sent{channel(0), channel(1), channel(2)};
    if (id != from) {
      const Vec3 own = row(id, knot) + Vec3(0.002f), its = row(from, knot) + Vec3(0.002f);
      sent = {sent.x * own.x / its.x, sent.y * own.y / its.y, sent.z * own.z / its.z};
    }
    hwy::float16_t red[lane_count], green[lane_count], blue[lane_count];
    store_halves(sent.x, red), store_halves(sent.y, green), store_halves(sent.z, blue);
    for (int l = 0; l < lane_count && k + l < count; ++l) {
      hwy::float16_t out[4] = {red[l], green[l], blue[l], {}};
      hwy::CopyBytes<sizeof(out)>(out, knots[k + l].light.data());
    }
  }
}

}  // namespace pelage::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
