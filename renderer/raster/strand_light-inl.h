// Lights points of strands, one strand in each lane: with the path tracer's fibre scattering, and shadows from the
// grid.
#if defined(PELAGE_RASTER_STRAND_LIGHT_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef PELAGE_RASTER_STRAND_LIGHT_INL_H_
#undef PELAGE_RASTER_STRAND_LIGHT_INL_H_
#else
#define PELAGE_RASTER_STRAND_LIGHT_INL_H_
#endif

#include <cstddef>

#include "renderer/coat/strand_tile.h"
#include "renderer/raster/kernels.h"
#include "renderer/raster/place-inl.h"
#include "renderer/raster/scene_light-inl.h"

HWY_BEFORE_NAMESPACE();
namespace pelage::HWY_NAMESPACE {

/// Returns unpack_colour of a word in each lane.
HWY_INLINE Vec3 unpacked_colour(Int word) {
  const auto channel = [](Int bits) HWY_ATTR {
    const Real share = to_real(hn::And(bits, splat(1023))) * (1.0f / 1023);
    return 4.0f * share * share;
  };
  return {channel(word), channel(hn::ShiftRight<10>(word)), channel(hn::ShiftRight<20>(word))};
}

/// The lit points of strands, and what all points of a strand share.
struct StrandLanes {
  Vec3 position[LitPoints::max], tangent[LitPoints::max];
  Int colour[LitPoints::max];
  Real height[LitPoints::max];
  Vec3 normal, ambient;
  Real number, longer;  // StrandRoot::number; factor on depth_above: crowding and length of the fur
  Real thin;            // [0, 1]: 1 where the coat is so low that the grid's cells make it look too thick
  Shine shine;
};

/// The knots of a strand at which light is computed, evenly spaced from `first` to the tip. On a straight strand, four
/// are as good as all knots (docs/notes/2026-11-27-strand-raster.md); curls need more. Below a third of its height, a
/// strand that is not drawn down to its root is hidden and not lit.
struct LitKnots {
  int first = 0, count = 4, segments = 1;

  LitKnots(int of_segments, bool from_root) : segments(of_segments) {
    if (segments > 8) count = std::min(segments / 4 + 1, LitPoints::max);
    if (!from_root) first = segments / 3, count = std::max(count - count / 4, 2);
  }
  int knot(int point) const { return first + point * (segments - first) / (count - 1); }
};

HWY_INLINE Vec3 knot_position(const StrandSet& set, Int rows, int knot) {
  const Quad point = gather_quad(&set.points[0].position.x + 4 * knot, rows);
  return {point.real(0), point.real(1), point.real(2)};
}

/// Returns 1 for a coat no higher than a cell, falling to 0 at two and a half cells.
HWY_INLINE Real thinness(const RasterScene& scene, const DepthLanes& depth) {
  const float cell = scene.grid->layout().cell;
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
  const Vec3 root = knot_position(set, rows, 0);
  Vec3 before = root;
  Real arc_length = 0.0f;
  StrandLanes strand;
  for (int p = 0; p < lit.count; ++p) {
    const int k = lit.knot(p);
    strand.position[p] = knot_position(set, rows, k);
    strand.tangent[p] =
        unit(knot_position(set, rows, std::min(k + 1, segments)) - knot_position(set, rows, std::max(k - 1, 0)));
    strand.colour[p] = gather(reinterpret_cast<const std::int32_t*>(set.colours.data()) + k, knots);
    arc_length += length(strand.position[p] - before), before = strand.position[p];
  }
  const DepthLanes depth = depth_lanes(set, ids, root, before, arc_length);
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
  fibre.position = strand.position[point], fibre.normal = strand.normal, fibre.tangent = strand.tangent[point];
  fibre.to_camera = unit(Vec3(camera.position) - fibre.position);
  fibre.colour = clamp(unpacked_colour(strand.colour[point]), 0.0f, 1.0f);
  fibre.height = strand.height[point];
  fibre.number = strand.number, fibre.shine = strand.shine;
  const Int slice = to_int(clamp(fibre.height * static_cast<float>(slice_count), 0.0f, slice_count - 1.0f));
  fibre.above = gather(&frame.depth_above[0].x, slice) * strand.longer;
  fibre.crossed = fibre.colour * colour_above(frame, fibre.height);
  return fibre;
}

/// Returns the luminance of direct light with shadows (x) and without (y).
HWY_INLINE Vec3 shadow_of(const SceneLight::SentLight& sent) {
  return {luminance(sent.direct), luminance(sent.unshadowed), 0.0f};
}

/// Returns what the scene shows of light. Callers compute the light once and select afterwards, because each call of
/// the inlined light code is another copy of it.
HWY_INLINE Vec3 light_output(const RasterScene& scene, const SceneLight::SentLight& sent) {
  switch (scene.output) {
    case RasterOutput::direct: return sent.direct;
    case RasterOutput::shadow: return shadow_of(sent);
    default: return sent.ambient + sent.direct;
  }
}

/// Returns the scene's field on a triangle of the model; `b` and `c` are barycentrics of its second and third corner.
HWY_INLINE Vec3 field_at(const RasterScene& scene, Int triangle, Real b, Real c) {
  const auto* corners = reinterpret_cast<const std::int32_t*>(scene.model->triangles.data());
  const Real shares[3] = {1.0f - b - c, b, c};
  Vec3 field(0.0f);
  for (int k = 0; k < 3; ++k) {
    const Int vertex = hn::Mul(gather(corners + k, hn::Mul(triangle, splat(3))), splat(3));
    const float* first = &scene.field[0].x;
    field += shares[k] * Vec3(gather(first, vertex), gather(first + 1, vertex), gather(first + 2, vertex));
  }
  return field;
}

/// Returns the field at the roots of strands; 0 for a strand that stands on no triangle.
HWY_INLINE Vec3 field_at_roots(const RasterScene& scene, const StrandSet& set, const std::uint32_t* ids) {
  const auto* roots = reinterpret_cast<const std::int32_t*>(set.roots.data());
  const Int rows = strand_rows(ids, root_stride);
  const Int triangle = gather(roots + offsetof(StrandRoot, triangle) / sizeof(float), rows);
  const Int shares = gather(roots + offsetof(StrandRoot, share) / sizeof(float), rows);
  const Real b = to_real(hn::And(shares, splat(0xffff))) * (1.0f / 65535);
  const Real c = to_real(hn::And(hn::ShiftRight<16>(shares), splat(0xffff))) * (1.0f / 65535);
  const Mask there = to_real(triangle) >= 0.0f;
  return select(there, field_at(scene, hn::Max(triangle, splat(0)), b, c), Vec3(0.0f));
}

/// Returns the colour of an object for RasterOutput::objects: 1 in its channel, or 0 if it is not among the three.
HWY_INLINE Vec3 object_mask(const RasterScene& scene, std::size_t object) {
  const auto is = [&](std::size_t channel)
                      HWY_ATTR { return Real(object == scene.first_object + channel ? 1.0f : 0.0f); };
  return {is(0), is(1), is(2)};
}

/// Returns what a part's strands show for outputs that need no light: the field at their roots, or their object.
HWY_INLINE Vec3 unlit(const RasterScene& scene, const GrownPart& part, const std::uint32_t* ids) {
  if (scene.output == RasterOutput::field) return field_at_roots(scene, *part.strands, ids);
  return object_mask(scene, object_of(scene.coats, part));
}

/// Returns what the scene shows of a fibre.
HWY_INLINE Vec3 output_value(SceneLight& from, const Fibre& fibre, Real thin, Vec3 ambient) {
  switch (from.scene.output) {
    case RasterOutput::albedo: return fibre.colour;
    case RasterOutput::normal: return fibre.normal;
    case RasterOutput::tangent: return fibre.tangent;
    default: break;
  }
  return light_output(from.scene, from.strand_light(fibre, thin, ambient, from.scene.output == RasterOutput::shadow));
}

HWY_INLINE void light_all(const RasterScene& scene, const GrownPart& part, std::span<const std::uint32_t> ids,
                          bool from_root, LitPoints& light) {
  const LitKnots lit(part.strands->segments, from_root);
  SceneLight from(scene);
  light.by_colour = is_coloured(scene.output);
  light.from = static_cast<float>(lit.first) / static_cast<float>(lit.segments), light.count = lit.count;
  const auto stride = static_cast<std::size_t>(lit.count);
  light.light.resize(ids.size() * stride);
  for (std::size_t i = 0; i < ids.size(); i += lane_count) {
    std::uint32_t lanes[lane_count];
    for (std::size_t l = 0; l < lane_count; ++l) lanes[l] = ids[std::min(i + l, ids.size() - 1)];
    const StrandLanes strand = strand_lanes(scene, part, lanes, lit);
    const bool is_unlit = scene.output == RasterOutput::field || scene.output == RasterOutput::objects;
    const Vec3 same = is_unlit ? unlit(scene, part, lanes) : Vec3(0.0f);
    const std::size_t there = std::min<std::size_t>(lane_count, ids.size() - i);
    for (std::size_t p = 0; p < stride; ++p) {
      Vec3 sent = is_unlit ? same
                           : output_value(from, fibre_at(scene.optics, scene.camera, strand, static_cast<int>(p)),
                                          strand.thin, strand.ambient);
      if (light.by_colour)
        sent =
            sent * each(unpacked_colour(strand.colour[p]), [](Real c) HWY_ATTR { return 1.0f / (c + black_offset); });
      float red[lane_count], green[lane_count], blue[lane_count];
      store(sent.x, red), store(sent.y, green), store(sent.z, blue);
      for (std::size_t l = 0; l < there; ++l) light.light[(i + l) * stride + p] = {red[l], green[l], blue[l], 0};
    }
  }
}

}  // namespace pelage::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
