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

}  // namespace pelage::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
