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

/// The vertices of the nearest skin of each lane.
class SkinPoint {
 public:
  HWY_INLINE SkinPoint(const MarchScene& scene, const SkinPixels& skin, int group) : scene_(scene) {
    const auto begin = static_cast<std::size_t>(group * lane_count);
    for (int i = 0; i < lane_count; ++i) {
      const std::int32_t piece = skin.piece[begin + static_cast<std::size_t>(i)];
      facing_[i] = piece >= 0 ? 1.0f : 0.0f;
      const auto number = static_cast<std::uint32_t>(piece >= 0 ? piece : ~piece);
      const ShellTriangle triangle{number, 0, true, skin.cut[begin + static_cast<std::size_t>(i)]};
      image_scale_[i] = scene.mesh.axes[number].image_scale;
      for (int k = 0; k < 3; ++k) {
        rows_[k][i] = static_cast<std::int32_t>(scene.row_of(triangle, k));
        corners_[k][i] = static_cast<std::int32_t>(scene.mesh.triangles[number][k]);
      }
    }
    inverse_ = load(&skin.inverse[begin]), second_ = load(&skin.second[begin]), third_ = load(&skin.third[begin]);
    there_ = {inverse_ > 0.0f};
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

/// Light that the skin sends to the camera. What AOVs keep of it goes into `shown` where that is given.
HWY_INLINE Vec3 skin_light(const MarchScene& scene, const Ray& ray, const SkinPoint& point, AovSums::Shown* shown) {
  const FrameOptics& optics = scene.optics;
  const FrameBlock& frame = optics.frame;
  const auto row = [&](int at) HWY_ATTR { return point.row(at); };
  const auto rows = [&](int at) HWY_ATTR { return point.rows(at); };
  const Mask facing = point.facing();
  Vec3 normal = unit(rows(Varyings::normal));
  normal = select(facing, normal, -normal);
  const Real length = row(Varyings::length);
  Real grown = smoothstep(0.0f, 0.008f, length);
  Real above = frame.depth_above[0].x * static_cast<float>(1 / nominal_length) * length;
  const PaintedFields fields = painted_fields(scene.varyings, row);
  if (optics.paint.form) {
    const Real thin = 1.0f - clamp(fields.density, 0.0f, 1.0f);
    grown *= 1.0f - thin * thin * thin;  // thinned fur does not hide the skin
    above *= fields.depth();
  }
  const Real furred =
      scene.bare ? select(facing, grown, 0.0f) : select(facing, grown, 0.0f) * rising_from_face(scene, ray, point);
  const Real covered = scene.bare ? Real(0.0f) : furred;  // the share that fur keeps light from
  const Real pixel = frame.viewpoint.w * point.distance() * ray.size, texels = pixel * point.image_scale();
  Vec3 undercoat = strand_colour(optics, scene.varyings, Vec3(frame.ramp_root), row, rows, texels);
  Cover painted{Vec3(0.0f), 0.0f};
  if (optics.paint.colour) {
    const PaintedColours colours = painted_colours(scene.varyings, row, rows);
    undercoat = covered_by(cover_at(colours, 0.0f), undercoat, 1.0f), painted = cover_at(colours, 0.5f);
  }
  if (optics.paint.form) undercoat = colour_wetted(optics.paint, fields.wetness, undercoat);
  const Vec3 bare = optics.model_colours ? model_colour(optics, scene.varyings.image, rows, texels) : Vec3(frame.skin);
  const Vec3 coat = covered_by(painted, undercoat * Vec3(frame.colour_above[0]), 1.0f);
  const Vec3 crossed = mix(bare, coat, furred);
  Vec3 colour = mix(bare, mix(coat, undercoat, furred), grown);
  const float self_shadow = frame.exponents.w;
  const Vec3 ambient = ambient_share(frame, 0.0f, above, stopped_by_strand(crossed, 0.6f, self_shadow));
  Vec3 sum = frame.weights.x * mix(Vec3(1.0f), ambient, covered) * colour * environment_light(optics, normal);
  const Vec3 stopped = stopped_by_strand(crossed, 1.0f, self_shadow);
  const Vec3 place = Vec3(scene.viewpoint) + ray.way * point.distance();
  Direct direct = Direct::none();
  const int at_open = scene.varyings.open;
  const Vec3 open = at_open < 0 ? place : rows(at_open);
  const Real hull = at_open < 0 ? Real(0.0f) : row(at_open + 3);
  for (int i = 0; i < optics.lights; ++i) {
    const Arriving light = light_at(optics, i, place);
    const Real cosine = dot(normal, light.to_light);
    Real strands = covered * strands_crossed(above, way_out(0.0f, cosine), normal, light.to_light);
    if (!optics.casters.empty())
      strands = shell_depth(optics.casters[static_cast<std::size_t>(i)], place, open, 0.0f, cosine, strands);
    const Vec3 through = each(stopped, [=](Real s) HWY_ATTR { return exp2(-1.442695f * strands * s); });
    const Real lit = frame.weights.y * max(cosine, 0.0f) * mix(1.0f, 0.6f, covered);
    Vec3 arriving = light.radiance * colour * through * lit;
    if (!optics.casters.empty())
      arriving *= cast_light(optics.casters[static_cast<std::size_t>(i)], place, open, hull, normal);
    if (shown) direct.add(arriving, light.radiance * colour * lit);
    sum += arriving;
  }
  if (optics.skin.count.x > 0 || optics.paint.form) {
    Bare region = optics.paint.form ? painted_bare(bare, fields.bare, fields.wetness) : not_bare();
    region = bare_over(optics.skin, region, place, normal, pixel);
    if (any(region.share > 0.0f)) {
      direct.keep(1.0f - region.share);
      sum = mix(sum,
                bare_light(optics, region, place, open, hull, normal, -ray.unit_way, pixel, shown ? &direct : nullptr),
                region.share);
      colour = mix(colour, region.colour, region.share);
    }
  }
  if (shown)
    *shown = {place,
              normal,
              select(length > 0.0f, unit(rows(Varyings::tangent)), Vec3(0.0f)),
              colour,
              direct,
              0.0f,
              1.0f / point.distance()};
  return sum;
}

}  // namespace pelage::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
