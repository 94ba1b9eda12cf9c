// Derives the light of a strand's knots from the lit points of the strand itself or of a neighbour.
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

/// Returns unpack_colour of a word, its channels in a register, plus black_offset, so that one can divide by black.
HWY_INLINE Colour colour_over_black(std::uint32_t packed) {
  const ColourTag tag;
  const hn::RebindToSigned<ColourTag> words;
  HWY_ALIGN constexpr std::int32_t of_channel[4] = {1023, 1023 << 10, 1023 << 20, 0};
  HWY_ALIGN constexpr float over_largest[4] = {2.0f / 1023, 2.0f / (1023 << 10), 2.0f / (1023 << 20), 0};
  const auto bits = hn::And(hn::Set(words, static_cast<std::int32_t>(packed)), hn::Load(words, of_channel));
  const Colour share = hn::Mul(hn::ConvertTo(tag, bits), hn::Load(tag, over_largest));
  return hn::MulAdd(share, share, hn::Set(tag, black_offset));
}

/// The colours of a strand's knots, and the factor on all of them.
struct KnotColours {
  std::span<const std::uint32_t> own;
  Colour factor;

  HWY_INLINE Colour at(std::size_t knot) const { return hn::Mul(colour_over_black(own[knot]), factor); }
};

/// Light along a strand, interpolated between the points of its lit strand. The strand is `taller` times as tall as
/// that one; a knot takes the light at its own height.
template <bool by_colour>
struct LightAlong {
  static constexpr ColourTag tag{};
  std::span<const glm::vec4> points;
  KnotColours colours;
  float first, step;  // position among the points of the first knot, and from knot to knot

  LightAlong(const LitPoints& lit, const glm::vec4* light, const KnotColours& of_knots, float taller)
      : points(light, static_cast<std::size_t>(lit.count)), colours(of_knots) {
    const float over = static_cast<float>(lit.count - 1) / std::max(1 - lit.from, 1e-3f);
    first = -lit.from * over, step = taller * over / static_cast<float>(colours.own.size() - 1);
  }

  /// Returns the position of a knot among the points. It ends one beyond the tip: the tip of a taller strand gets more
  /// light than that of the lit strand.
  HWY_INLINE float point_coordinate(int knot) const {
    return std::clamp(first + static_cast<float>(knot) * step, 0.0f, static_cast<float>(points.size()));
  }
  /// Returns the light of a point. The point after the tip holds how much more light the tip has than the point before
  /// it.
  HWY_INLINE Colour light_of(int point) const {
    const bool beyond = point == static_cast<int>(points.size());
    const glm::vec4* light = &points[static_cast<std::size_t>(beyond ? point - 1 : point)];
    const Colour here = hn::LoadU(tag, &light->x);
    return beyond ? hn::Sub(here, hn::LoadU(tag, &(light - 1)->x)) : here;
  }
  /// Returns the weight of a point's light at a position at most one away from it; that of the tip stays 1 beyond it.
  HWY_INLINE float share_of(int point, float coordinate) const {
    const float after = coordinate - static_cast<float>(point);
    const bool is_tip = point + 1 == static_cast<int>(points.size());
    return after > 0 && is_tip ? 1 : std::max(1 - std::abs(after), 0.0f);
  }
  HWY_INLINE Colour colour_of(int knot) const {
    return by_colour ? colours.at(static_cast<std::size_t>(knot)) : hn::Set(tag, 1.0f);
  }
};

/// The light at both ends of the segment between two drawn knots. The segment sends the mean light of all knots of the
/// strand between its ends, however few are drawn. For each point, its ends differ as the light at their own positions
/// does, but no end gets a negative share of a point. So light stays positive and linear in the lights.
template <bool by_colour>
class SegmentLight {
 public:
  HWY_INLINE SegmentLight(const LightAlong<by_colour>& light, int begin, int end)
      : light_(light), begin_coordinate_(light.point_coordinate(begin)), end_coordinate_(light.point_coordinate(end)) {
    begin_colour_ = light.colour_of(begin), end_colour_ = light.colour_of(end);
    const float share = 1 / static_cast<float>(end - begin);
    low_ = std::min(static_cast<int>(begin_coordinate_), static_cast<int>(light.points.size()) - 1);
    add(begin_coordinate_, 0.5f * share, begin_colour_);
    for (int k = begin + 1; k < end; ++k) add(light.point_coordinate(k), share, light.colour_of(k));
    add(end_coordinate_, 0.5f * share, end_colour_);
    next_point();
    const bool ends_beyond = low_ == static_cast<int>(light_.points.size());
    if (!ends_beyond) next_point();
    even_out();
    if (ends_beyond) next_point();  // the gain beyond the tip is not light that all points have
  }

  Colour at_begin = hn::Zero(tag), at_end = hn::Zero(tag);

 private:
  static constexpr ColourTag tag{};

  HWY_INLINE void add(float coordinate, float share, Colour colour) {
    while (coordinate >= static_cast<float>(low_ + 1) && low_ + 1 < static_cast<int>(light_.points.size()))
      next_point();
    const auto of_point = [&](int point) { return hn::Set(tag, share * light_.share_of(point, coordinate)); };
    mean_ = hn::MulAdd(colour, of_point(low_), mean_);
    next_mean_ = hn::MulAdd(colour, of_point(low_ + 1), next_mean_);
  }

  /// Adds the light of the point `low_` to both ends, and goes on to the next point.
  HWY_INLINE void next_point() {
    const auto half = [this](float coordinate) { return hn::Set(tag, 0.5f * light_.share_of(low_, coordinate)); };
    const Colour at_own =
        hn::MulSub(begin_colour_, half(begin_coordinate_), hn::Mul(end_colour_, half(end_coordinate_)));
    const Colour tilt = hn::Clamp(at_own, hn::Neg(mean_), mean_), light = light_.light_of(low_);
    at_begin = hn::MulAdd(hn::Add(mean_, tilt), light, at_begin);
    at_end = hn::MulAdd(hn::Sub(mean_, tilt), light, at_end);
    all_ = hn::Add(all_, mean_), wanted_ = hn::Add(wanted_, at_own), tilt_ = hn::Add(tilt_, tilt);
    mean_ = next_mean_, next_mean_ = hn::Zero(tag), ++low_;
  }

  /// Makes light that is the same at all points also the same at both ends: moves what the clamps gave to the wrong
  /// end.
  HWY_INLINE void even_out() {
    const Colour zero = hn::Zero(tag), one = hn::Set(tag, 1.0f), tiny = hn::Set(tag, 1e-12f);
    const Colour missing = hn::Sub(wanted_, tilt_);  // at the begin, over all points
    const auto share = [&](Colour part, Colour of) { return hn::Clamp(hn::Div(part, hn::Max(of, tiny)), zero, one); };
    const Colour from_end = hn::Mul(share(missing, hn::Sub(all_, tilt_)), at_end),
                 from_begin = hn::Mul(share(hn::Neg(missing), hn::Add(all_, tilt_)), at_begin);
    at_begin = hn::Add(at_begin, hn::Sub(from_end, from_begin));
    at_end = hn::Sub(at_end, hn::Sub(from_end, from_begin));
  }

  const LightAlong<by_colour>& light_;
  float begin_coordinate_, end_coordinate_;
  Colour begin_colour_, end_colour_;
  Colour mean_ = hn::Zero(tag), next_mean_ = hn::Zero(tag);  // mean weight of the point, and of the one after it
  // Sums over the points so far: of mean weights, and of how the begin's weight differs from the mean, before and after
  // the clamp.
  Colour all_ = hn::Zero(tag), wanted_ = hn::Zero(tag), tilt_ = hn::Zero(tag);
  int low_ = 0;  // the current point
};

inline constexpr float max_half = 65504;  // largest half float, in which knots store light

/// Writes the light of a strand's drawn knots, which lie at the positions `along` it: the mean of the ends of the
/// segments that meet there.
template <bool by_colour>
HWY_INLINE void hand_on(const LightAlong<by_colour>& light, std::span<const float> along, PlacedKnot* knots) {
  static_assert(sizeof(hwy::float16_t) == sizeof(std::uint16_t));
  const hn::Rebind<hwy::float16_t, ColourTag> halves;
  const auto segments = static_cast<float>(light.colours.own.size() - 1);
  const auto knot_at = [&](std::size_t k) { return static_cast<int>(along[k] * segments + 0.5f); };
  const auto keep = [&](std::size_t k, Colour before, Colour after) {
    const Colour mean = hn::Mul(hn::Add(before, after), hn::Set(light.tag, 0.5f));
    const Colour clamped = hn::Clamp(mean, hn::Set(light.tag, by_colour ? 0 : -max_half), hn::Set(light.tag, max_half));
    hn::StoreU(hn::DemoteTo(halves, clamped), halves, reinterpret_cast<hwy::float16_t*>(knots[k].light.data()));
  };
  Colour before = hn::Zero(light.tag);
  for (std::size_t k = 1; k < along.size(); ++k) {
    const SegmentLight<by_colour> segment(light, knot_at(k - 1), knot_at(k));
    keep(k - 1, k == 1 ? segment.at_begin : before, segment.at_begin);
    before = segment.at_end;
  }
  keep(along.size() - 1, before, before);
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
  const std::size_t from_root = sources.from_root.light.size() / static_cast<std::size_t>(sources.from_root.count);
  for (std::size_t i = 0; i < sources.ids.size(); ++i) {
    const std::size_t lit = sources.lit[i];
    const LitPoints& points = lit < from_root ? sources.from_root : sources.upper_part;
    const glm::vec4* light =
        &points.light[(lit < from_root ? lit : lit - from_root) * static_cast<std::size_t>(points.count)];
    const float taller = set.roots[sources.ids[i]].reach / std::max(set.roots[sources.from[i]].reach, 1e-3f);
    const std::uint32_t begin = placed.first[first + i], end = placed.first[first + i + 1];
    const LightAlong<by_colour> along(points, light, knot_colours(set, sources.ids[i], sources.own_colour), taller);
    hand_on(along, std::span(placed.along).subspan(begin, end - begin), &placed.knots[begin]);
  }
}

}  // namespace pelage::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
