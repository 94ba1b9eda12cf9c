// Light of a strand's knots from that of its points, or of its neighbour's by their colours.
#if defined(PELAGE_RASTER_HAND_ON_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef PELAGE_RASTER_HAND_ON_INL_H_
#undef PELAGE_RASTER_HAND_ON_INL_H_
#else
#define PELAGE_RASTER_HAND_ON_INL_H_
#endif

#include "renderer/raster/strand_light-inl.h"

HWY_BEFORE_NAMESPACE();
namespace pelage::HWY_NAMESPACE {

using ColourTag = hn::CappedTag<float, 4>;
using Colour = hn::Vec<ColourTag>;

/// pack_colour undone, its channels in a register, with a little more so that black can be divided by.
HWY_INLINE Colour colour_over_black(std::uint32_t packed) {
  const ColourTag tag;
  const hn::RebindToSigned<ColourTag> words;
  HWY_ALIGN const std::int32_t channels[4] = {static_cast<std::int32_t>(packed & 1023),
                                              static_cast<std::int32_t>(packed >> 10 & 1023),
                                              static_cast<std::int32_t>(packed >> 20 & 1023), 0};
  const Colour share = hn::Mul(hn::ConvertTo(tag, hn::Load(words, channels)), hn::Set(tag, 2.0f / 1023));
  return hn::MulAdd(share, share, hn::Set(tag, 0.002f));
}

HWY_INLINE void hand_on(const StrandSet& set, std::uint32_t id, std::uint32_t from, const LitStrandPoints& light,
                        const float* along, PlacedKnot* knots, int count) {
  static_assert(sizeof(hwy::float16_t) == sizeof(std::uint16_t));
  const ColourTag tag;
  const hn::Rebind<hwy::float16_t, ColourTag> halves;
  const auto segments = static_cast<std::size_t>(set.segments);
  const float over = static_cast<float>(light.count - 1) / std::max(1 - light.from, 1e-3f);
  for (int k = 0; k < count; ++k) {
    const float at = std::max((along[k] - light.from) * over, 0.0f);
    const int low = std::min(static_cast<int>(at), light.count - 2);
    const Colour a = hn::LoadU(tag, &light.light[static_cast<std::size_t>(low)].x);
    const Colour b = hn::LoadU(tag, &light.light[static_cast<std::size_t>(low) + 1].x);
    Colour sent = hn::MulAdd(hn::Sub(b, a), hn::Set(tag, at - static_cast<float>(low)), a);
    if (id != from) {
      const auto knot = static_cast<std::size_t>(along[k] * static_cast<float>(segments) + 0.01f);
      const Colour own = colour_over_black(set.colours[id * (segments + 1) + knot]);
      sent = hn::Mul(sent, hn::Div(own, colour_over_black(set.colours[from * (segments + 1) + knot])));
    }
    const auto half = hn::DemoteTo(halves, hn::Min(sent, hn::Set(tag, 65504.0f)));
    hn::StoreU(half, halves, reinterpret_cast<hwy::float16_t*>(knots[k].light.data()));
  }
}

}  // namespace pelage::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
