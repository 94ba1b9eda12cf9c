// The skin behind the fur of a group of pixels: the undercoat where fur grows, a matt surface elsewhere. The twin of
// renderer/passes/fur/skin.frag.
#if defined(PELAGE_MARCHED_SKIN_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef PELAGE_MARCHED_SKIN_INL_H_
#undef PELAGE_MARCHED_SKIN_INL_H_
#else
#define PELAGE_MARCHED_SKIN_INL_H_
#endif

#include "renderer/marched/march-inl.h"
#include "renderer/optics/bare_skin-inl.h"

HWY_BEFORE_NAMESPACE();
namespace pelage::HWY_NAMESPACE {

/// The vertices of the nearest skin of each lane; at least one has some. Lanes without read another's: the rows of a
/// piece that is not drawn were never written.
class SkinPoint {
 public:
  HWY_INLINE SkinPoint(const MarchScene& scene, const SkinPixels& skin, int group) : scene_(scene) {
    const auto begin = static_cast<std::size_t>(group * lane_count);
    there_ = {load(&skin.inverse[begin]) > 0.0f};
    std::size_t some = begin;
    while (some + 1 < begin + lane_count && !(skin.inverse[some] > 0)) ++some;
    float inverse[lane_count], second[lane_count], third[lane_count];
    for (int i = 0; i < lane_count; ++i) {
      const std::size_t own = begin + static_cast<std::size_t>(i), pixel = skin.inverse[own] > 0 ? own : some;
      inverse[i] = skin.inverse[pixel], second[i] = skin.second[pixel], third[i] = skin.third[pixel];
      const std::int32_t piece = skin.piece[pixel];
      facing_[i] = piece >= 0 ? 1.0f : 0.0f;
      const auto number = static_cast<std::uint32_t>(piece >= 0 ? piece : ~piece);
      const ShellTriangle triangle{number, 0, true, skin.cut[pixel]};
      image_scale_[i] = scene.mesh.axes[number].image_scale;
      for (int k = 0; k < 3; ++k) {
        rows_[k][i] = static_cast<std::int32_t>(scene.row_of(triangle, k));
        corners_[k][i] = static_cast<std::int32_t>(scene.mesh.triangles[number][k]);
      }
    }
    inverse_ = load(inverse), second_ = load(second), third_ = load(third);
    distance_ = 1.0f / max(inverse_, 1e-20f);
  }
  HWY_INLINE Mask there() const { return there_; }
  HWY_INLINE Real image_scale() const { return load(image_scale_); }
  HWY_INLINE Mask facing() const { return load(facing_) > 0.5f; }
  HWY_INLINE Real distance() const { return distance_; }
  HWY_INLINE Real corner(int k, int at) const { return read(rows_[k], 0, at); }
  HWY_INLINE Real row(int at) const {
    const Real a = corner(0, at);
    return distance_ * mul_add(second_, corner(1, at) - a, mul_add(third_, corner(2, at) - a, a));
  }
  HWY_INLINE Vec3 rows(int at) const { return {row(at), row(at + 1), row(at + 2)}; }
  /// Of the mesh's own corner on a shell.
  HWY_INLINE Vec3 place_of(int k, int shell) const {
    constexpr int at = Varyings::place;
    const std::size_t first = scene_.row_of(shell, 0);
    return {read(corners_[k], first, at), read(corners_[k], first, at + 1), read(corners_[k], first, at + 2)};
  }

 private:
  HWY_INLINE Real read(const std::int32_t* rows, std::size_t first, int at) const {
    return gather(scene_.row(first) + at, hn::Mul(hn::LoadU(int_tag, rows), whole(scene_.varyings.stride)));
  }
  const MarchScene& scene_;
  std::int32_t rows_[3][lane_count], corners_[3][lane_count];  // of the triangle as it is seen, and of the mesh
  float facing_[lane_count], image_scale_[lane_count];
  Real inverse_, second_, third_, distance_;
  Mask there_;
};

/// 1 where fur rises out of the face, 0 where it turns over in a fold and grows into the body.
HWY_INLINE Real rising_from_face(const MarchScene& scene, const Ray& ray, const SkinPoint& point) {
  int hull = 0;
  while (hull + 1 < scene.shells.count() && scene.shells.heights[static_cast<std::size_t>(hull)] < hull_height) ++hull;
  const Vec3 a = point.place_of(0, 0), b = point.place_of(1, 0), c = point.place_of(2, 0);
  Vec3 across = cross(b - a, c - a);
  across = select(dot(across, ray.way) > 0.0f, -across, across);
  const Vec3 offset = (point.place_of(0, hull) - a) + (point.place_of(1, hull) - b) + (point.place_of(2, hull) - c);
  const Real size = length(across) * length(offset);
  return select(size > 0.0f, smoothstep(-0.1f, 0.15f, dot(across, offset) / max(size, 1e-30f)), 1.0f);
}

/// Where a ray meets the skin, and where light that the body lets through comes to the fur there: on its hull.
struct SkinPlace {
  Vec3 at, normal, open;
  Real hull;   // how high that is, sizes
  Real pixel;  // size of a pixel there, sizes
};

HWY_INLINE SkinPlace skin_place(const MarchScene& scene, const Ray& ray, const SkinPoint& point) {
  const Vec3 normal = unit(point.rows(Varyings::normal));
  SkinPlace place;
  place.at = Vec3(scene.viewpoint) + ray.way * point.distance();
  place.normal = select(point.facing(), normal, -normal);
  const int open = scene.varyings.open;
  place.open = open < 0 ? place.at : point.rows(open);
  place.hull = open < 0 ? Real(0.0f) : point.row(open + 3);
  place.pixel = scene.optics.frame.viewpoint.w * point.distance() * ray.size;
  return place;
}

/// How fur covers a place of the skin; shares in [0, 1].
struct SkinCover {
  PaintedFields fields;
  Real length;
  Real grown;    // of the undercoat's colour
  Real furred;   // of the coat's
  Real covered;  // that the fur keeps light from
  Real above;    // strands over it
};

HWY_INLINE SkinCover skin_cover(const MarchScene& scene, const Ray& ray, const SkinPoint& point) {
  const auto row = [&](int at) HWY_ATTR { return point.row(at); };
  SkinCover cover;
  cover.fields = painted_fields(scene.varyings, row);
  cover.length = row(Varyings::length);
  cover.grown = smoothstep(0.0f, 0.008f, cover.length);
  cover.above = scene.optics.frame.depth_above[0].x * static_cast<float>(1 / nominal_length) * cover.length;
  if (scene.optics.paint.form) {
    const Real thin = 1.0f - clamp(cover.fields.density, 0.0f, 1.0f);
    cover.grown *= 1.0f - thin * thin * thin;  // thinned fur does not hide the skin
    cover.above *= cover.fields.depth();
  }
  cover.furred = select(point.facing(), cover.grown, 0.0f);
  if (!scene.bare) cover.furred *= rising_from_face(scene, ray, point);
  cover.covered = scene.bare ? Real(0.0f) : cover.furred;
  return cover;
}

struct SkinColours {
  Vec3 bare, seen;
  Vec3 crossed;  // what light goes through
};

HWY_INLINE SkinColours skin_colours(const MarchScene& scene, const SkinPoint& point, const SkinCover& cover,
                                    Real texels) {
  const FrameOptics& optics = scene.optics;
  const auto row = [&](int at) HWY_ATTR { return point.row(at); };
  const auto rows = [&](int at) HWY_ATTR { return point.rows(at); };
  Vec3 undercoat = strand_colour(optics, scene.varyings, Vec3(optics.frame.ramp_root), row, rows, texels);
  Cover painted{Vec3(0.0f), 0.0f};
  if (optics.paint.colour) {
    const PaintedColours colours = painted_colours(scene.varyings, row, rows);
    undercoat = covered_by(cover_at(colours, 0.0f), undercoat, 1.0f), painted = cover_at(colours, 0.5f);
  }
  if (optics.paint.form) undercoat = colour_wetted(optics.paint, cover.fields.wetness, undercoat);
  const Vec3 bare =
      optics.model_colours ? model_colour(optics, scene.varyings.image, rows, texels) : Vec3(optics.frame.skin);
  const Vec3 coat = covered_by(painted, undercoat * Vec3(optics.frame.colour_above[0]), 1.0f);
  return {bare, mix(bare, mix(coat, undercoat, cover.furred), cover.grown), mix(bare, coat, cover.furred)};
}

/// Of all lights. `direct` is added to where it is given.
HWY_INLINE Vec3 lights_on_skin(const FrameOptics& optics, const SkinPlace& place, const SkinCover& cover,
                               const SkinColours& colours, Direct* direct) {
  const Vec3 stopped = stopped_by_strand(colours.crossed, 1.0f, optics.frame.exponents.w);
  Vec3 sum(0.0f);
  for (int i = 0; i < optics.lights; ++i) {
    const Arriving light = light_at(optics, i, place.at);
    const Real cosine = dot(place.normal, light.to_light);
    Real strands = cover.covered * strands_crossed(cover.above, way_out(0.0f, cosine), place.normal, light.to_light);
    const ShadowCaster* caster = optics.casters.empty() ? nullptr : &optics.casters[static_cast<std::size_t>(i)];
    if (caster) strands = shell_depth(*caster, place.at, place.open, 0.0f, cosine, strands);
    const Vec3 through = each(stopped, [=](Real s) HWY_ATTR { return exp2(-1.442695f * strands * s); });
    const Real lit = optics.frame.weights.y * max(cosine, 0.0f) * mix(1.0f, 0.6f, cover.covered);
    Vec3 arriving = light.radiance * colours.seen * through * lit;
    if (caster) arriving *= cast_light(*caster, place.at, place.open, place.hull, place.normal);
    if (direct) direct->add(arriving, light.radiance * colours.seen * lit);
    sum += arriving;
  }
  return sum;
}

/// Light that the skin sends to the camera. What AOVs keep of it goes into `shown` where that is given.
HWY_INLINE Vec3 skin_light(const MarchScene& scene, const Ray& ray, const SkinPoint& point, AovSums::Shown* shown) {
  const FrameOptics& optics = scene.optics;
  const SkinPlace place = skin_place(scene, ray, point);
  const SkinCover cover = skin_cover(scene, ray, point);
  const SkinColours colours = skin_colours(scene, point, cover, place.pixel * point.image_scale());
  const Vec3 ambient = ambient_share(optics.frame, 0.0f, cover.above,
                                     stopped_by_strand(colours.crossed, 0.6f, optics.frame.exponents.w));
  Direct direct = Direct::none();
  Vec3 seen = colours.seen;
  Vec3 sum = optics.frame.weights.x * mix(Vec3(1.0f), ambient, cover.covered) * seen *
                 environment_light(optics, place.normal) +
             lights_on_skin(optics, place, cover, colours, shown ? &direct : nullptr);
  if (optics.skin.count.x > 0 || optics.paint.form) {
    Bare region = optics.paint.form ? painted_bare(colours.bare, cover.fields.bare, cover.fields.wetness) : not_bare();
    region = bare_over(optics.skin, region, place.at, place.normal, place.pixel);
    if (any(region.share > 0.0f)) {
      direct.keep(1.0f - region.share);
      sum = mix(sum,
                bare_light(optics, region, place.at, place.open, place.hull, place.normal, -ray.unit_way, place.pixel,
                           shown ? &direct : nullptr),
                region.share);
      seen = mix(seen, region.colour, region.share);
    }
  }
  if (!shown) return sum;
  const Vec3 tangent = select(cover.length > 0.0f, unit(point.rows(Varyings::tangent)), Vec3(0.0f));
  *shown = {place.at, place.normal, tangent, seen, direct, 0.0f, 1.0f / point.distance()};
  return sum;
}

}  // namespace pelage::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
