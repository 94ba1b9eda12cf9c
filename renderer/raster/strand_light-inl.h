// Light on strands, a strand a lane: the tracer's own scattering, and shadows from the grid.
#if defined(PELAGE_RASTER_STRAND_LIGHT_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef PELAGE_RASTER_STRAND_LIGHT_INL_H_
#undef PELAGE_RASTER_STRAND_LIGHT_INL_H_
#else
#define PELAGE_RASTER_STRAND_LIGHT_INL_H_
#endif

#include <cstddef>

#include "renderer/coat/strand_tile.h"
#include "renderer/optics/light-inl.h"
#include "renderer/raster/kernels.h"
#include "renderer/raster/place-inl.h"

HWY_BEFORE_NAMESPACE();
namespace pelage::HWY_NAMESPACE {

/// Cells above a place by which its shadow is read: as its own cell holds what lies below it too.
inline constexpr float off_skin = 0.25f;

/// pack_colour, undone.
HWY_INLINE Vec3 unpacked_colour(Int word) {
  const auto channel = [](Int bits) HWY_ATTR {
    const Real share = to_real(hn::And(bits, whole(1023))) * (1.0f / 1023);
    return 4.0f * share * share;
  };
  return {channel(word), channel(hn::ShiftRight<10>(word)), channel(hn::ShiftRight<20>(word))};
}

/// Added to colours, so that black can be divided by.
inline constexpr float over_black = 0.002f;

/// Where a place lies among the cells of a grid.
struct GridLanes {
  Int first;
  Real weight[8];
  int step[8];
};

HWY_INLINE GridLanes grid_lanes(const GridPlace& grid, Vec3 place) {
  const auto along = [](Real at, int size) HWY_ATTR { return clamp(at, 0.0f, static_cast<float>(size) - 1.001f); };
  const Vec3 off = (place - Vec3(grid.low)) * (1 / grid.cell) - Vec3(0.5f);
  const Vec3 at{along(off.x, grid.size.x), along(off.y, grid.size.y), along(off.z, grid.size.z)};
  const Vec3 low{floor(at.x), floor(at.y), floor(at.z)}, part = at - low;
  GridLanes lanes;
  lanes.first = hn::Add(hn::Mul(hn::Add(hn::Mul(to_int(low.z), whole(grid.size.y)), to_int(low.y)), whole(grid.size.x)),
                        to_int(low.x));
  for (int k = 0; k < 8; ++k) {
    lanes.weight[k] =
        (k & 1 ? part.x : 1.0f - part.x) * (k & 2 ? part.y : 1.0f - part.y) * (k & 4 ? part.z : 1.0f - part.z);
    lanes.step[k] = (k & 1) + (k & 2 ? grid.size.x : 0) + (k & 4 ? grid.size.x * grid.size.y : 0);
  }
  return lanes;
}

/// What lies between a place and a light.
struct CrossedLanes {
  Real strands, body;
};

HWY_INLINE CrossedLanes crossed_at(std::span<const Crossed> cells, const GridLanes& lanes) {
  const auto* words = reinterpret_cast<const std::int32_t*>(cells.data());
  Real strands = 0.0f, body = 0.0f;
  for (int k = 0; k < 8; ++k) {
    const Int word = gather(words + lanes.step[k], lanes.first);
    strands = mul_add(lanes.weight[k], to_real(hn::And(word, whole(0xffff))), strands);
    body = mul_add(lanes.weight[k], to_real(hn::ShiftRight<16>(word)), body);
  }
  return {strands * (1 / Crossed::one), body * (1 / Crossed::one)};
}

/// How much single strands count at a place for the picture, [0, 1]: it shows little across from near.
HWY_INLINE Real nearness(const RasterScene& scene, Vec3 place) {
  const Real distance = dot(place - Vec3(scene.camera.position), Vec3(scene.camera.forward));
  const Real view = distance * (static_cast<float>(std::max(scene.width, scene.height)) / scene.camera.scale);
  return 1.0f - smoothstep(NearCells::whole_view, NearCells::no_view, view);
}

/// Of a light, what gets past strands that each stop so much of it, and past the body.
HWY_INLINE Vec3 let_through(const CrossedLanes& crossed, Vec3 stopped) {
  const Real strands = crossed.strands, body = crossed.body;
  return each(stopped, [=](Real s) HWY_ATTR { return exp2(-1.442695f * mul_add(strands, s, body)); });
}

/// Strands that light crosses in near cells on its last way to a fibre.
HWY_INLINE Real near_strands(const NearCells& near, Vec3 place, Vec3 tangent, Vec3 to_light) {
  const auto* cells = reinterpret_cast<const std::int32_t*>(near.cells().data());
  const Vec3 at = place * (1 / near.cell());
  const auto part = [](Real along, std::uint32_t factor)
                        HWY_ATTR { return hn::Mul(to_int(floor(along)), whole(static_cast<int>(factor))); };
  Real sum = 0.0f;
  for (int k = 0; k < NearCells::steps; ++k) {
    const Vec3 there = at + to_light * (static_cast<float>(k) + 0.5f);
    const Int hashed =
        hn::Xor3(part(there.x, NearCells::of_x), part(there.y, NearCells::of_y), part(there.z, NearCells::of_z));
    const Int index = hn::And(hashed, whole(NearCells::count - 1));
    const Int pair = gather(cells, hn::ShiftRight<1>(index));
    sum += to_real(hn::And(hn::Shr(pair, hn::ShiftLeft<4>(hn::And(index, whole(1)))), whole(0xffff)));
  }
  const Real own = sum - NearCells::steps * near.mean();
  return strands_crossed(own * (1 / NearCells::one), 1.0f, tangent, to_light);
}

/// The strands to a light: near a fibre single ones, from where their cells end what the grid has.
HWY_INLINE Real with_near(const RasterScene& scene, std::size_t light, const Fibre& fibre, Vec3 to_light, Real nearness,
                          Real crossed) {
  const GridPlace& grid = scene.grid->place();
  const float way = scene.near->cell() * NearCells::steps;
  const GridLanes beyond = grid_lanes(grid, fibre.place + to_light * way + fibre.normal * (off_skin * grid.cell));
  const Real near = near_strands(*scene.near, fibre.place, fibre.tangent, to_light);
  return mix(crossed, max(near + crossed_at(scene.grid->crossed(light), beyond).strands, 0.0f), nearness);
}

/// What strands share along their length, and their points that are lit.
struct StrandLanes {
  Vec3 place[LitPoints::max], tangent[LitPoints::max];
  Int colour[LitPoints::max];
  Real height[LitPoints::max];
  Vec3 normal, ambient;
  Real number, longer;
  Real thin;  // share of the coat that lies within a few cells of the grid, which sees it too thick, [0, 1]
  Shine shine;
};

/// Points of a strand that are lit: knots from the first on, evenly to the tip. Thirds of a straight strand do as
/// well as all of its knots (docs/notes/2026-11-27-strand-raster.md); more on curls.
struct LitKnots {
  int first = 0, count = 4, segments = 1;

  LitKnots(int of_segments, bool whole_strand) : segments(of_segments) {
    if (segments > 8) count = std::min(segments / 4 + 1, LitPoints::max);
    if (!whole_strand) first = segments / 3, count = std::max(count - count / 4, 2);
  }
  int knot(int point) const { return first + point * (segments - first) / (count - 1); }
};

HWY_INLINE Vec3 place_of(const StrandSet& set, Int rows, int knot) {
  const Quad point = gather_quad(&set.points[0].place.x + 4 * knot, rows);
  return {point.real(0), point.real(1), point.real(2)};
}

/// 1 for a coat no higher than a cell, 0 from two and a half cells on.
HWY_INLINE Real thinness(const RasterScene& scene, const DepthLanes& depth) {
  const float cell = scene.grid->place().cell;
  const Real height = dot(depth.tip - depth.root, depth.normal) / max(depth.reach, 0.01f);
  return 1.0f - smoothstep(1.0f * cell, 2.5f * cell, height);
}

HWY_INLINE StrandLanes strand_lanes(const RasterScene& scene, const GrownPart& part, const std::uint32_t* ids,
                                    const LitKnots& lit) {
  const FrameOptics& optics = scene.optics;
  const StrandSet& set = *part.strands;
  const int segments = set.segments;
  const Int rows = strand_rows(ids, (segments + 1) * 4), knots = strand_rows(ids, segments + 1),
            roots = strand_rows(ids, root_stride);
  const Vec3 root = place_of(set, rows, 0);
  Vec3 before = root;
  Real way = 0.0f;
  StrandLanes strand;
  for (int p = 0; p < lit.count; ++p) {
    const int k = lit.knot(p);
    strand.place[p] = place_of(set, rows, k);
    strand.tangent[p] = unit(place_of(set, rows, std::min(k + 1, segments)) - place_of(set, rows, std::max(k - 1, 0)));
    strand.colour[p] = gather(reinterpret_cast<const std::int32_t*>(set.colours.data()) + k, knots);
    way += length(strand.place[p] - before), before = strand.place[p];
  }
  const DepthLanes depth = depth_lanes(set, ids, root, before, way);
  for (int p = 0; p < lit.count; ++p)
    strand.height[p] = depth.reach * (static_cast<float>(lit.knot(p)) / static_cast<float>(segments));
  strand.normal = depth.normal, strand.number = gather(&set.roots[0].number, roots);
  strand.longer = depth.length * part.crowding;
  strand.thin = part.role == StrandRole::coat ? thinness(scene, depth) : Real(0.0f);
  strand.shine = shine_of(optics.wetness, gather(&set.roots[0].wetness, roots));
  strand.ambient = optics.frame.weights.x * FrameLight(optics).environment_light(strand.normal);
  return strand;
}

HWY_INLINE Fibre fibre_at(const FrameOptics& optics, const PictureCamera& camera, const StrandLanes& strand,
                          int point) {
  const FrameBlock& frame = optics.frame;
  Fibre fibre;
  fibre.place = strand.place[point], fibre.normal = strand.normal, fibre.tangent = strand.tangent[point];
  fibre.to_camera = unit(Vec3(camera.position) - fibre.place);
  fibre.colour = clamp(unpacked_colour(strand.colour[point]), 0.0f, 1.0f);
  fibre.height = strand.height[point];
  fibre.number = strand.number, fibre.shine = strand.shine;
  const Int slice = to_int(clamp(fibre.height * static_cast<float>(slice_count), 0.0f, slice_count - 1.0f));
  fibre.above = gather(&frame.depth_above[0].x, slice) * strand.longer;
  fibre.crossed = fibre.colour * colour_above(frame, fibre.height);
  return fibre;
}

/// Light that a fibre or a place of the skin sends to the camera.
struct SentLight {
  Vec3 ambient, direct;
  Vec3 unshadowed;  // `direct` as if nothing stopped it; where it is asked for

  HWY_INLINE Vec3 shadow() const { return {luminance(direct), luminance(unshadowed), 0.0f}; }
};

template <bool unshadowed>
HWY_INLINE SentLight strand_light(const RasterScene& scene, const Fibre& fibre, Real thin, Vec3 ambient) {
  const FrameOptics& optics = scene.optics;
  FrameLight from(optics);
  FibreScattering by{optics.scattering, *optics.azimuthal};
  const Vec3 stopped = from.stopped_by_strand(fibre.crossed, 1.0f);
  SentLight sum;
  sum.ambient = fibre.colour * ambient *
                from.ambient_share(fibre.height, fibre.above, from.stopped_by_strand(fibre.crossed, 0.6f));
  sum.direct = sum.unshadowed = Vec3(0.0f);
  const FibreView view = from.view_of(fibre);
  FibreEye eye;
  if (scatters_fibres(optics.model)) eye = by.fibre_eye(fibre);
  const GridPlace& grid = scene.grid->place();
  const GridLanes cells = grid_lanes(grid, fibre.place + fibre.normal * (off_skin * grid.cell));
  const Real near = scene.near && !scene.near->cells().empty() ? nearness(scene, fibre.place) : Real(0.0f);
  const bool is_near = any(near > 0.0f);
  for (int i = 0; i < optics.lights; ++i) {
    const auto number = static_cast<Index>(i);
    const Arriving light = from.light_at(number, fibre.place);
    const Real facing = dot(fibre.normal, light.to_light);
    CrossedLanes crossed = crossed_at(scene.grid->crossed(number), cells);
    if (is_near) crossed.strands = with_near(scene, number, fibre, light.to_light, near, crossed.strands);
    const Real way = way_out(fibre.height, facing);
    const Real known = strands_crossed(fibre.above, way, fibre.tangent, light.to_light);
    const Real between = mix(crossed.strands, min(crossed.strands, known), thin);
    const Real strands = strands_not_shared(fibre, view, light.to_light, way, between);
    const Vec3 through = let_through({strands, crossed.body}, stopped);
    const Vec3 scattered = by.scatter(optics.model, fibre, eye, light.to_light);
    const Vec3 sent = light.radiance * scattered * light_behind(optics.model, facing, optics.frame.exponents.z);
    sum.direct += sent * through;
    if constexpr (unshadowed) sum.unshadowed += sent;
  }
  return sum;
}

/// What a field is on a piece of the model, by the shares of its second and third corner.
HWY_INLINE Vec3 field_at(const RasterScene& scene, Int piece, Real b, Real c) {
  const auto* corners = reinterpret_cast<const std::int32_t*>(scene.model->triangles.data());
  const Real shares[3] = {1.0f - b - c, b, c};
  Vec3 field(0.0f);
  for (int k = 0; k < 3; ++k) {
    const Int vertex = hn::Mul(gather(corners + k, hn::Mul(piece, whole(3))), whole(3));
    const float* first = &scene.field[0].x;
    field += shares[k] * Vec3(gather(first, vertex), gather(first + 1, vertex), gather(first + 2, vertex));
  }
  return field;
}

/// At the roots of strands; 0 where they stand on no piece.
HWY_INLINE Vec3 field_at_roots(const RasterScene& scene, const StrandSet& set, const std::uint32_t* ids) {
  const auto* roots = reinterpret_cast<const std::int32_t*>(set.roots.data());
  const Int rows = strand_rows(ids, root_stride);
  const Int piece = gather(roots + offsetof(StrandRoot, piece) / sizeof(float), rows);
  const Int shares = gather(roots + offsetof(StrandRoot, share) / sizeof(float), rows);
  const Real b = to_real(hn::And(shares, whole(0xffff))) * (1.0f / 65535);
  const Real c = to_real(hn::And(hn::ShiftRight<16>(shares), whole(0xffff))) * (1.0f / 65535);
  const Mask there = to_real(piece) >= 0.0f;
  return select(there, field_at(scene, hn::Max(piece, whole(0)), b, c), Vec3(0.0f));
}

/// What the scene shows of a fibre.
HWY_INLINE Vec3 shown_of(const RasterScene& scene, const Fibre& fibre, Real thin, Vec3 ambient) {
  switch (scene.shown) {
    case RasterOutput::albedo: return fibre.colour;
    case RasterOutput::normal: return fibre.normal;
    case RasterOutput::tangent: return fibre.tangent;
    case RasterOutput::direct: return strand_light<false>(scene, fibre, thin, ambient).direct;
    case RasterOutput::shadow: return strand_light<true>(scene, fibre, thin, ambient).shadow();
    default: break;
  }
  const SentLight light = strand_light<false>(scene, fibre, thin, ambient);
  return light.ambient + light.direct;
}

HWY_INLINE void light_all(const RasterScene& scene, const GrownPart& part, std::span<const std::uint32_t> ids,
                          bool whole_strand, LitPoints& light) {
  const LitKnots lit(part.strands->segments, whole_strand);
  light.by_colour = is_coloured(scene.shown);
  light.from = static_cast<float>(lit.first) / static_cast<float>(lit.segments), light.count = lit.count;
  const auto stride = static_cast<std::size_t>(lit.count);
  light.light.resize(ids.size() * stride);
  for (std::size_t i = 0; i < ids.size(); i += lane_count) {
    std::uint32_t lanes[lane_count];
    for (std::size_t l = 0; l < lane_count; ++l) lanes[l] = ids[std::min(i + l, ids.size() - 1)];
    const StrandLanes strand = strand_lanes(scene, part, lanes, lit);
    const bool is_field = scene.shown == RasterOutput::field;
    const Vec3 field = is_field ? field_at_roots(scene, *part.strands, lanes) : Vec3(0.0f);
    const std::size_t there = std::min<std::size_t>(lane_count, ids.size() - i);
    for (std::size_t p = 0; p < stride; ++p) {
      Vec3 sent = is_field ? field
                           : shown_of(scene, fibre_at(scene.optics, scene.camera, strand, static_cast<int>(p)),
                                      strand.thin, strand.ambient);
      if (light.by_colour)
        sent = sent * each(unpacked_colour(strand.colour[p]), [](Real c) HWY_ATTR { return 1.0f / (c + over_black); });
      float red[lane_count], green[lane_count], blue[lane_count];
      store(sent.x, red), store(sent.y, green), store(sent.z, blue);
      for (std::size_t l = 0; l < there; ++l) light.light[(i + l) * stride + p] = {red[l], green[l], blue[l], 0};
    }
  }
}

// Light of a strand's knots from that of its points, or of its neighbour's.

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

/// Light along a strand, from that of the points of the one that is lit, which it is so many times `taller` than: knots
/// have the light of the same height.
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
