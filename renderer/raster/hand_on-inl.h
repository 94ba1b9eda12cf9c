// Light of a strand's knots from that of its points, or of its neighbour's.
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
  return hn::MulAdd(share, share, hn::Set(tag, over_black));
}

/// To the knots of a strand, which lie `along` it, by their own colours.
template <bool by_colour>
HWY_INLINE void hand_on(const LitPoints& points, const glm::vec4* light, std::span<const std::uint32_t> colours,
                        std::span<const float> along, PlacedKnot* knots) {
  static_assert(sizeof(hwy::float16_t) == sizeof(std::uint16_t));
  const ColourTag tag;
  const hn::Rebind<hwy::float16_t, ColourTag> halves;
  const float over = static_cast<float>(points.count - 1) / std::max(1 - points.from, 1e-3f);
  const auto segments = static_cast<float>(colours.size() - 1);
  for (std::size_t k = 0; k < along.size(); ++k) {
    const float at = std::max((along[k] - points.from) * over, 0.0f);
    const int low = std::min(static_cast<int>(at), points.count - 2);
    const Colour a = hn::LoadU(tag, &light[low].x), b = hn::LoadU(tag, &light[low + 1].x);
    Colour sent = hn::MulAdd(hn::Sub(b, a), hn::Set(tag, at - static_cast<float>(low)), a);
    if constexpr (by_colour)
      sent = hn::Mul(sent, colour_over_black(colours[static_cast<std::size_t>(along[k] * segments + 0.5f)]));
    const auto half = hn::DemoteTo(halves, hn::Min(sent, hn::Set(tag, 65504.0f)));
    hn::StoreU(half, halves, reinterpret_cast<hwy::float16_t*>(knots[k].light.data()));
  }
}

template <bool by_colour>
HWY_INLINE void hand_on_all(const StrandSet& set, const LightSources& sources, std::size_t first,
                            PlacedStrands& placed) {
  const std::size_t whole = sources.whole.light.size() / static_cast<std::size_t>(sources.whole.count);
  const auto knots = static_cast<std::size_t>(set.segments) + 1;
  for (std::size_t i = 0; i < sources.ids.size(); ++i) {
    const std::size_t lit = sources.lit[i];
    const LitPoints& points = lit < whole ? sources.whole : sources.rest;
    const glm::vec4* light = &points.light[(lit < whole ? lit : lit - whole) * static_cast<std::size_t>(points.count)];
    const std::uint32_t begin = placed.first[first + i], end = placed.first[first + i + 1];
    hand_on<by_colour>(points, light, std::span(set.colours).subspan(sources.ids[i] * knots, knots),
                       std::span(placed.along).subspan(begin, end - begin), &placed.knots[begin]);
  }
}

}  // namespace pelage::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
