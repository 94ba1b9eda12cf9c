// Marching through the fur of a group of pixels: samples of the coat between two crossings, lit once a segment.
#if defined(PELAGE_MARCHED_MARCH_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef PELAGE_MARCHED_MARCH_INL_H_
#undef PELAGE_MARCHED_MARCH_INL_H_
#else
#define PELAGE_MARCHED_MARCH_INL_H_
#endif

#include "renderer/marched/coat_tile-inl.h"
#include "renderer/marched/raster-inl.h"
#include "renderer/marched/seen-inl.h"
#include "renderer/optics/colours-inl.h"
#include "renderer/optics/light-inl.h"

HWY_BEFORE_NAMESPACE();
namespace pelage::HWY_NAMESPACE {

/// The records of one end of a segment, one for each lane. What every frame reads is read once.
class End {
 public:
  HWY_INLINE End(const MarchScene& scene, const TileScratch& scratch, const std::uint32_t* records,
                 const std::int32_t* lanes)
      : values_(scratch.values.data()) {
    const int numbers = scene.varyings.count() * lane_count;
    std::int32_t at[lane_count];
    for (int i = 0; i < lane_count; ++i) at[i] = static_cast<std::int32_t>(records[i]) * numbers + lanes[i];
    index_ = hn::LoadU(int_tag, at);
    distance = 1.0f / raw(Varyings::inverse);
    u = row(Varyings::tile), v = row(Varyings::tile + 1);
    normal = rows(Varyings::normal), tangent = rows(Varyings::tangent);
    length = row(Varyings::length), share = row(Varyings::share);
  }
  HWY_INLINE Real row(int at) const { return raw(at) * distance; }
  HWY_INLINE Vec3 rows(int at) const { return {row(at), row(at + 1), row(at + 2)}; }

  Real distance, u, v, length, share;
  Vec3 normal, tangent;

 private:
  HWY_INLINE Real raw(int at) const { return gather(values_ + (at - Varyings::first) * lane_count, index_); }
  const float* values_;
  Int index_;
};

/// The segments of all lanes at one step.
struct Segments {
  std::uint32_t near[lane_count], far[lane_count];
  float near_height[lane_count], far_height[lane_count], dense[lane_count];
  std::int32_t piece[lane_count];
  std::int32_t lane[lane_count];  // whose numbers are read: another's where a lane has no segment
  Mask there;
  int samples;  // of the coat in each
};

/// A segment as the samples see it: all runs evenly along it but the height, which bends as the skin does.
struct Path {
  Real u0, v0, du, dv;      // tiles
  Real height, rise, bend;  // s(t) = height + rise t + bend t (1 - t)
  Real length;              // of the fur, sizes
  Real depth;               // factor on the stored depth of a sample
  Int first, side;          // of the level of the atlas: its texels
  Real level;               // before it is rounded
  PaintedFields fields;
  Gathering tuft, clump;
  PaintedCurl curl;

  HWY_INLINE Real height_at(Real t) const { return clamp(height + t * (rise + bend * (1.0f - t)), 0.0f, 0.999999f); }
};

/// At this sine of the ray's angle to the stack, even between 0, 30, 60 and 75 degrees (depth_scale_of of slab.glsl).
HWY_INLINE Real depth_scale_of(const FrameBlock& frame, Int level, Real sine) {
  const Quad scales = gather_quad(&frame.depth_scale[0].x, hn::ShiftLeft<2>(level));
  const Real along = scales.real(0), at60 = scales.real(1), at30 = scales.real(2), at75 = scales.real(3);
  const Real low = mix(along, at30, min(2.0f * sine, 1.0f));
  const Real middle = mix(low, at60, clamp((sine - 0.5f) * 2.7320508f, 0.0f, 1.0f));
  return mix(middle, at75, clamp((sine - 0.8660254f) * 10.0102f, 0.0f, 1.0f));
}

/// What samples have found of a segment: sums weighted by opacity. Light to the fourth, as slab.glsl.
struct Slab {
  Real opacity, at, height, light, slope_x, slope_y, number;
  Vec3 colour;
};

/// Where strands that gather and curl have their root, and how dense they are, at a height of a segment.
HWY_INLINE Gathered bent_at(const MarchScene& scene, const Path& path, Real height) {
  Gathered bent{{0.0f, 0.0f}, 1.0f};
  if (scene.optics.tufts.volume) bent = gathered_at(path.tuft, height);
  if (!scene.optics.paint.form) return bent;
  const Gathered clump = gathered_at(path.clump, height);
  const float length = static_cast<float>(nominal_length) * scene.optics.frame.tile.x;
  bent.shift += clump.shift - curl_offset(path.curl, height) * length;
  bent.depth *= clump.depth * path.fields.width;
  return bent;
}

HWY_INLINE void take_sample(const MarchScene& scene, const Path& path, Real t, Slab& slab) {
  const Real height = path.height_at(t);
  Vec2 at{mul_add(path.du, t, path.u0), mul_add(path.dv, t, path.v0)};
  Real share = 1.0f;
  if (scene.bends) {
    const Gathered bent = bent_at(scene, path, height);
    at += bent.shift, share = bent.depth;
  }
  const TilePlace place(*scene.atlas, path.first, path.side, to_int(height * static_cast<float>(slice_count)));
  const Real texels = to_real(path.side), x = at.x * texels, y = at.y * texels;
  if (scene.optics.paint.form) share *= strand_share(place, x, y, path.fields.density, floor(path.level + 0.5f));
  const Int nearest_x = to_int(floor(x)), nearest_y = to_int(floor(y));
  const Texel shape = place.smooth_shape(x, y);
  const Real weight = (1.0f - slab.opacity) * (1.0f - exp2(-path.depth * share * shape.w));
  slab.opacity += weight;
  slab.at += weight * t, slab.height += weight * height;
  const Real square = shape.z * shape.z;
  slab.light += weight * square * square;
  slab.slope_x += weight * shape.x, slab.slope_y += weight * shape.y;
  const Texel strand = texel_of(gather(scene.atlas->colours.data(), place.word(nearest_x, nearest_y)));
  slab.colour += weight * Vec3(strand.x * strand.x, strand.y * strand.y, strand.z * strand.z);
  slab.number += weight * strand.w;
}

/// What a pixel's rays share.
struct Ray {
  Vec3 way;       // 1 along the view
  Real size;      // of the way
  Vec3 unit_way;  // unit
  Real offset;    // of the samples of this pixel, [0, 1)
};

HWY_INLINE Real level_of(const MarchScene& scene, const Ray& ray, Real distance, Vec3 normal) {
  const FrameBlock& frame = scene.optics.frame;
  const Real facing = abs(dot(ray.unit_way, normal));
  const Real pixel = frame.viewpoint.w * distance * ray.size;
  const Real level = log2(pixel * (1 / frame.tile.y)) - 0.25f * log2(max(facing, 0.2f));
  return clamp(level, static_cast<float>(scene.atlas->finest), slice_levels - 1.0f);
}

/// The tile's u axis, unit.
HWY_INLINE Vec3 tile_axis_of(const MarchScene& scene, const Segments& segments) {
  const Int axes = hn::Mul(hn::LoadU(int_tag, segments.piece), whole(sizeof(PieceAxes) / sizeof(float)));
  const Quad tile_u = gather_quad(&scene.mesh.axes[0].tile_u.x, axes);
  return {tile_u.real(0), tile_u.real(1), tile_u.real(2)};
}

/// How the skin and its fur lie between two ends, and how a ray meets them.
struct Lie {
  Vec3 normal, tangent;                  // unit
  Real upright;                          // cosine between both
  Real near_facing, middle, far_facing;  // cosine between the normal and the way back at the ends and between
};

HWY_INLINE Lie lie_of(const Ray& ray, const End& near, const End& far) {
  Lie lie;
  lie.normal = unit(near.normal + far.normal), lie.tangent = unit(near.tangent + far.tangent);
  lie.upright = max(dot(lie.tangent, lie.normal), 0.15f);
  lie.near_facing = -dot(ray.unit_way, near.normal), lie.far_facing = -dot(ray.unit_way, far.normal);
  lie.middle = 0.5f * (lie.near_facing + lie.far_facing);
  return lie;
}

/// Half the difference of the height's slopes at the ends, by which it bends; no further than one shell.
HWY_INLINE Real bend_of(const MarchScene& scene, const Lie& lie, Real way, Real length) {
  const float shell = 4.0f / static_cast<float>(std::max(scene.shells.count() - 1, 1));
  const Real up = way / max(length * lie.upright, 1e-6f);
  return clamp(0.5f * up * (lie.far_facing - lie.near_facing), -shell, 0.0f);
}

/// The height that a path goes down and up, over that of the fur.
HWY_INLINE Real climbed_by(const Path& path) {
  const Real rise = abs(path.rise), bend = -path.bend;
  return select(bend > rise, 0.5f * (rise * rise + bend * bend) / max(bend, 1e-9f), rise);
}

/// As fur_vertex.glsl: the way through the coat by the height, by how far it moves sideways past the strands, and by
/// what it meets of those that lie (science.md 1). By the smooth normals and not by the way itself, which the mesh's
/// facets make shorter and longer. A facing below .2 counts as .2.
HWY_INLINE Real way_through(const Ray& ray, const Lie& lie, const Path& path, Real climbed) {
  const auto mean = [&](auto function) HWY_ATTR {
    return 0.25f * (function(abs(lie.near_facing)) + function(abs(lie.far_facing))) + 0.5f * function(abs(lie.middle));
  };
  const Real risen = mean([](Real facing) HWY_ATTR { return facing; });
  const Real counted = mean([](Real facing) HWY_ATTR { return min(5.0f * facing, 1.0f); });
  const Real moved = climbed * path.length * lie.upright * counted / max(risen, 1e-4f);
  const Vec3 along = lie.tangent - lie.upright * lie.normal, back = -ray.unit_way;
  const Vec3 past = moved * (back - dot(back, lie.normal) * lie.normal) + path.length * path.rise * along;
  const Real aside = dot(cross(along, ray.unit_way), lie.normal) * moved / lie.upright;
  const float over_nominal = static_cast<float>(1 / nominal_length);
  const Real sideways = over_nominal * over_nominal * (dot(past, past) + aside * aside);
  return min(sqrt(climbed * climbed + sideways), 10.0f * climbed);
}

/// How a ray goes through the coat between two ends.
HWY_INLINE Path path_of(const MarchScene& scene, const Ray& ray, const Segments& segments, const End& near,
                        const End& far) {
  const FrameBlock& frame = scene.optics.frame;
  const Lie lie = lie_of(ray, near, far);
  Path path;
  path.u0 = near.u, path.v0 = near.v;
  path.du = far.u - near.u, path.dv = far.v - near.v;
  path.height = load(segments.near_height), path.rise = load(segments.far_height) - path.height;
  path.length = 0.5f * (near.length + far.length);
  path.bend = bend_of(scene, lie, (far.distance - near.distance) * ray.size, path.length);
  path.level = level_of(scene, ray, 0.5f * (near.distance + far.distance), lie.normal);
  const Int level = to_int(path.level + 0.5f);
  path.first = gather(scene.atlas->first.data(), level), path.side = hn::Shr(whole(slice_texels), level);
  const Real climbed = climbed_by(path), way = way_through(ray, lie, path, climbed);
  const Real sine = sqrt(max(1.0f - climbed * climbed / max(way * way, 1e-20f), 0.0f));
  const Real share = 0.5f * (near.share + far.share) * load(segments.dense);
  const float scale = static_cast<float>(stored_depth) * 1.442695f * static_cast<float>(slice_count) /
                      static_cast<float>(segments.samples);
  const Real depth = scale * share * way * depth_scale_of(frame, level, sine);
  path.depth = select(segments.there & (depth > 0.0f), depth, 0.0f);
  return path;
}

/// What bends the strands of a segment, as its middle has it.
HWY_INLINE void add_bends(const MarchScene& scene, const Segments& segments, const End& near, const End& far,
                          Path& path) {
  const auto row = [&](int at) HWY_ATTR { return 0.5f * (near.row(at) + far.row(at)); };
  const Vec2 tile{path.u0 + 0.5f * path.du, path.v0 + 0.5f * path.dv};
  if (scene.optics.paint.form) {
    path.fields = painted_fields(scene.varyings, row);
    path.clump = painted_clump(scene.optics.paint, path.fields, tile, path.level);
    path.curl = painted_curl(scene.optics.paint, path.fields, tile);
    path.depth = select(path.fields.density > 0.0f, path.depth, 0.0f);
  }
  if (!scene.optics.tufts.volume) return;
  const int at = scene.varyings.root;
  const Tuft tuft = tuft_at(scene.optics.tufts, {row(at), row(at + 1), row(at + 2)}, 0.5f * (near.length + far.length));
  const Vec3 normal = unit(near.normal + far.normal), tile_u = tile_axis_of(scene, segments);
  const Real tile_x = scene.optics.frame.tile.x;
  path.tuft = {{dot(tuft.to_middle, tile_u) * tile_x, dot(tuft.to_middle, cross(normal, tile_u)) * tile_x},
               tuft.inside,
               tuft.gather};
}

/// The tangent of a strand that the samples have found: the fur's, turned by the slope that the coat has stored (over
/// +-1 of stored_slope), and by what gathers and curls.
HWY_INLINE Vec3 strand_tangent(const MarchScene& scene, const Path& path, Vec3 tangent, const Fibre& fibre, Vec3 tile_u,
                               Vec2 stored) {
  const Vec3 tile_v = cross(fibre.normal, tile_u);
  const auto turned = [&](Vec2 by) HWY_ATTR { return unit(tangent + tile_u * by.x + tile_v * by.y); };
  const Vec2 slope = (stored * 2.0f - Vec2{1.0f, 1.0f}) * static_cast<float>(stored_slope / nominal_length);
  tangent = turned(slope);
  if (scene.optics.paint.form) {
    const Real over = 1 / (scene.optics.frame.tile.x * static_cast<float>(nominal_length));
    tangent = turned(curl_slope(path.curl, fibre.height) + lean_to_middle(path.clump, fibre.height) * over);
  }
  if (scene.optics.tufts.volume)
    tangent = turned(lean_to_middle(path.tuft, fibre.height) *
                     (1.0f / (scene.optics.frame.tile.x * max(path.length, 1e-4f))));
  return tangent;
}

/// Of many strands about a place, linear: the coarsest level.
HWY_INLINE Vec3 mean_colour(const SliceAtlas& atlas, Vec2 tile, Real height) {
  constexpr int level = slice_levels - 1, side = slice_texels >> level;
  const TilePlace place(atlas, whole(atlas.first[level]), whole(side),
                        to_int(min(height, 0.999999f) * static_cast<float>(slice_count)));
  const auto texel = [](Real at) HWY_ATTR { return to_int(floor(at * static_cast<float>(side))); };
  const Texel mean = texel_of(gather(atlas.colours.data(), place.word(texel(tile.x), texel(tile.y))));
  return {mean.x * mean.x, mean.y * mean.y, mean.z * mean.z};
}

/// What share of an image's side a pixel sees. Nothing reads it where there is no image.
HWY_INLINE Real image_pixel(const MarchScene& scene, const Ray& ray, const Segments& segments, Real distance) {
  if (!scene.optics.images) return 0.0f;
  const Int axes = hn::Mul(hn::LoadU(int_tag, segments.piece), whole(sizeof(PieceAxes) / sizeof(float)));
  return gather(&scene.mesh.axes[0].image_scale, axes) * distance * ray.size * scene.optics.frame.viewpoint.w;
}

/// The strand that a segment's samples have found.
HWY_INLINE Fibre fibre_of(const MarchScene& scene, const Ray& ray, const Segments& segments, const End& near,
                          const End& far, const Path& path, const Slab& slab) {
  const FrameOptics& optics = scene.optics;
  const Real share = 1.0f / max(slab.opacity, 1e-9f), t = slab.at * share;
  const auto row = [&](int at) HWY_ATTR { return mix(near.row(at), far.row(at), t); };
  const auto rows = [&](int at) HWY_ATTR { return Vec3(row(at), row(at + 1), row(at + 2)); };
  Fibre fibre;
  fibre.height = slab.height * share, fibre.strand = slab.number * share;
  fibre.normal = unit(mix(near.normal, far.normal, t));
  fibre.tangent = strand_tangent(scene, path, unit(mix(near.tangent, far.tangent, t)), fibre,
                                 tile_axis_of(scene, segments), {slab.slope_x * share, slab.slope_y * share});
  const Real length_share = mix(near.length, far.length, t) * static_cast<float>(1 / nominal_length);
  fibre.above = -0.25f * static_cast<float>(stored_light) * log(max(slab.light * share, 1e-9f)) * length_share *
                load(segments.dense);
  fibre.place = Vec3(scene.viewpoint) + ray.way * mix(near.distance, far.distance, t);
  fibre.to_camera = -ray.unit_way;
  fibre.shine = {1.0f, 1.0f};
  const int open = scene.varyings.open;
  fibre.open = open < 0 ? fibre.place : rows(open);
  fibre.hull = open < 0 ? Real(0.0f) : row(open + 3);
  fibre.colour = strand_colour(optics, scene.varyings, slab.colour * share, row, rows,
                               image_pixel(scene, ray, segments, near.distance));
  Cover above{Vec3(0.0f), 0.0f};
  if (optics.paint.colour) {
    const PaintedColours paint = painted_colours(scene.varyings, row, rows);
    const Vec3 mean = mean_colour(*scene.atlas, {path.u0 + t * path.du, path.v0 + t * path.dv}, fibre.height);
    const Real lighter = clamp(luminance(slab.colour * share) / max(luminance(mean), 1e-4f), 0.5f, 1.6f);
    fibre.colour = covered_by(cover_at(paint, fibre.height), fibre.colour, lighter);
    above = cover_at(paint, 0.5f * (fibre.height + 1.0f));
  }
  if (optics.paint.form) {
    fibre.above *= path.fields.depth();
    fibre.colour = colour_wetted(optics.paint, path.fields.wetness, fibre.colour);
    fibre.shine = shine_of(optics.paint, path.fields.wetness);
  }
  fibre.crossed = covered_by(above, fibre.colour * colour_above(optics.frame, fibre.height), 1.0f);
  return fibre;
}

/// Where a ray goes through a segment, and what its samples find there.
struct Sampled {
  Path path;
  Slab slab;
};

HWY_INLINE Sampled slab_of(const MarchScene& scene, const Ray& ray, const Segments& segments, const End& near,
                           const End& far) {
  const Real none = 0.0f;
  Sampled sampled{path_of(scene, ray, segments, near, far), {none, none, none, none, none, none, none, Vec3(none)}};
  if (scene.bends) add_bends(scene, segments, near, far, sampled.path);
  const float step = 1.0f / static_cast<float>(segments.samples);
  for (int i = 0; i < segments.samples; ++i)
    take_sample(scene, sampled.path, (static_cast<float>(i) + ray.offset) * step, sampled.slab);
  return sampled;
}

/// One step of all lanes.
HWY_INLINE void march(const MarchScene& scene, const Ray& ray, const Segments& segments, const End& near,
                      const End& far, Seen& seen) {
  const Sampled sampled = slab_of(scene, ray, segments, near, far);
  const Slab& slab = sampled.slab;
  const Mask met = slab.opacity > 0.0005f;
  if (!any(met)) return;
  const Fibre fibre = fibre_of(scene, ray, segments, near, far, sampled.path, slab);
  const Real weight = select(met, seen.through * slab.opacity, 0.0f);
  Direct direct = Direct::none();
  seen.light += fibre_light(scene.optics, fibre, seen.aovs ? &direct : nullptr) * weight;
  if (seen.aovs) {
    const Real distance = mix(near.distance, far.distance, slab.at / max(slab.opacity, 1e-9f));
    seen.aovs->add({fibre.place, fibre.normal, fibre.tangent, fibre.colour, direct, select(met, Real(1.0f), 0.0f),
                    1.0f / distance},
                   weight, seen.through);
  }
  seen.through -= weight;
}

}  // namespace pelage::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
