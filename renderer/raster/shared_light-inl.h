// Light of a strand's knots from that of its points, or of its neighbour's.
#if defined(PELAGE_RASTER_SHARED_LIGHT_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef PELAGE_RASTER_SHARED_LIGHT_INL_H_
#undef PELAGE_RASTER_SHARED_LIGHT_INL_H_
#else
#define PELAGE_RASTER_SHARED_LIGHT_INL_H_
#endif

#include <hwy/highway.h>

#include "renderer/raster/kernels.h"
#include "renderer/raster/strand_light-inl.h"

HWY_BEFORE_NAMESPACE();
namespace pelage::HWY_NAMESPACE {

using ColourTag = hn::CappedTag<float, 4>;
using Colour = hn::Vec<ColourTag>;

/// pack_colour undone, its channels in a register, with a little more so that black can be divided by.
HWY_INLINE Colour colour_over_black(std::uint32_t packed) {
  const ColourTag tag;
  const hn::RebindToSigned<ColourTag> words;
  HWY_ALIGN constexpr std::int32_t of_channel[4] = {1023, 1023 << 10, 1023 << 20, 0};
  HWY_ALIGN constexpr float over_largest[4] = {2.0f / 1023, 2.0f / (1023 << 10), 2.0f / (1023 << 20), 0};
  const auto bits = hn::And(hn::Set(words, static_cast<std::int32_t>(packed)), hn::Load(words, of_channel));
  const Colour share = hn::Mul(hn::ConvertTo(tag, bits), hn::Load(tag, over_largest));
  return hn::MulAdd(share, share, hn::Set(tag, over_black));
}

/// Colours of a strand's knots, and what they are multiplied by.
struct KnotColours {
  std::span<const std::uint32_t> own;
  Colour factor;

  HWY_INLINE Colour at(std::size_t knot) const { return hn::Mul(colour_over_black(own[knot]), factor); }
};

/// Light along a strand, derived from the points of the lit strand; the strand is `taller` times as tall as that one.
/// Knots have the light of the same height.
template <bool by_colour>
struct LightAlong {
  static constexpr ColourTag tag{};
  static constexpr float beyond_tip = 1;  // points; what is taller gets more light than the tip
  std::span<const glm::vec4> points;
  KnotColours colours;
  float first, step;  // of the points, at the first knot and from knot to knot

  LightAlong(const LitPoints& lit, const glm::vec4* light, const KnotColours& of_knots, float taller)
      : points(light, static_cast<std::size_t>(lit.count)), colours(of_knots) {
    const float over = static_cast<float>(lit.count - 1) / std::max(1 - lit.from, 1e-3f);
    first = -lit.from * over, step = taller * over / static_cast<float>(colours.own.size() - 1);
  }

  HWY_INLINE Colour at(int knot) const {
    const float last = static_cast<float>(points.size() - 1) + beyond_tip;
    const float place = std::clamp(first + static_cast<float>(knot) * step, 0.0f, last);
    const int low = std::min(static_cast<int>(place), static_cast<int>(points.size()) - 2);
    const Colour a = hn::LoadU(tag, &points[static_cast<std::size_t>(low)].x),
                 b = hn::LoadU(tag, &points[static_cast<std::size_t>(low) + 1].x);
    const Colour sent = hn::MulAdd(hn::Sub(b, a), hn::Set(tag, place - static_cast<float>(low)), a);
    if constexpr (!by_colour) return sent;
    return hn::Mul(hn::Max(sent, hn::Zero(tag)), colours.at(static_cast<std::size_t>(knot)));
  }

  /// What the knots between two that are drawn send beyond the straight line between these, in the mean: so much more
  /// each of them sends, so that a strand sends what it does, however few are drawn.
  HWY_INLINE Colour left_out(int begin, Colour at_begin, int end, Colour at_end) const {
    Colour sum = hn::Zero(tag);
    const float over = 1 / static_cast<float>(std::max(end - begin, 1));
    const Colour rise = hn::Mul(hn::Sub(at_end, at_begin), hn::Set(tag, over));
    Colour straight = at_begin;
    for (int k = begin + 1; k < end; ++k)
      straight = hn::Add(straight, rise), sum = hn::Add(sum, hn::Sub(at(k), straight));
    return hn::Mul(sum, hn::Set(tag, over));
  }
};

inline constexpr float max_half = 65504;  // of half floats, in which knots keep light

/// To the knots that are drawn of a strand, which lie `along` it.
template <bool by_colour>
HWY_INLINE void hand_on(const LightAlong<by_colour>& light, std::span<const float> along, PlacedKnot* knots) {
  static_assert(sizeof(hwy::float16_t) == sizeof(std::uint16_t));
  const hn::Rebind<hwy::float16_t, ColourTag> halves;
  const auto segments = static_cast<float>(light.colours.own.size() - 1);
  const auto knot_at = [&](std::size_t k) { return static_cast<int>(along[k] * segments + 0.5f); };
  int knot = knot_at(0);
  Colour sent = light.at(knot), more_before = hn::Zero(light.tag);
  for (std::size_t k = 0; k < along.size(); ++k) {
    const bool is_last = k + 1 == along.size();
    const int next = is_last ? knot : knot_at(k + 1);
    const Colour at_next = is_last ? sent : light.at(next);
    const Colour more_after = is_last ? more_before : light.left_out(knot, sent, next, at_next);
    if (k == 0) more_before = more_after;
    const Colour whole = hn::MulAdd(hn::Add(more_before, more_after), hn::Set(light.tag, 0.5f), sent);
    const Colour shown = hn::Clamp(whole, hn::Set(light.tag, by_colour ? 0 : -max_half), hn::Set(light.tag, max_half));
    hn::StoreU(hn::DemoteTo(halves, shown), halves, reinterpret_cast<hwy::float16_t*>(knots[k].light.data()));
    knot = next, sent = at_next, more_before = more_after;
  }
}

HWY_INLINE KnotColours knot_colours(const StrandSet& set, std::uint32_t strand, float own) {
  const ColourTag tag;
  const auto knots = static_cast<std::size_t>(set.segments) + 1;
  const Colour one = hn::Set(tag, 1.0f);
  Colour factor = one;
  if (own < 1 && !set.to_mean.empty())
    factor = hn::MulAdd(hn::Sub(colour_over_black(set.to_mean[strand]), one), hn::Set(tag, 1 - own), one);
  return {std::span(set.colours).subspan(strand * knots, knots), factor};
}

template <bool by_colour>
HWY_INLINE void hand_on_all(const StrandSet& set, const LightSources& sources, std::size_t first,
                            PlacedStrands& placed) {
  const std::size_t whole = sources.whole.light.size() / static_cast<std::size_t>(sources.whole.count);
  for (std::size_t i = 0; i < sources.ids.size(); ++i) {
    const std::size_t lit = sources.lit[i];
    const LitPoints& points = lit < whole ? sources.whole : sources.rest;
    const glm::vec4* light = &points.light[(lit < whole ? lit : lit - whole) * static_cast<std::size_t>(points.count)];
    const float taller = set.roots[sources.ids[i]].reach / std::max(set.roots[sources.from[i]].reach, 1e-3f);
    const std::uint32_t begin = placed.first[first + i], end = placed.first[first + i + 1];
    const LightAlong<by_colour> along(points, light, knot_colours(set, sources.ids[i], sources.own_colour), taller);
    hand_on(along, std::span(placed.along).subspan(begin, end - begin), &placed.knots[begin]);
  }
}

}  // namespace pelage::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
