// Light of the skin between strands, a pixel a lane.
#if defined(PELAGE_RASTER_SKIN_LIGHT_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef PELAGE_RASTER_SKIN_LIGHT_INL_H_
#undef PELAGE_RASTER_SKIN_LIGHT_INL_H_
#else
#define PELAGE_RASTER_SKIN_LIGHT_INL_H_
#endif

#include "renderer/optics/bare_skin-inl.h"
#include "renderer/raster/pixel_rays-inl.h"
#include "renderer/raster/strand_light-inl.h"

HWY_BEFORE_NAMESPACE();
namespace pelage::HWY_NAMESPACE {

HWY_INLINE Vec3 gather_vec3(const float* from, Int index) {
  return {gather(from, index), gather(from + 1, index), gather(from + 2, index)};
}

/// The skin where it is seen.
struct SkinLanes {
  Vec3 place, normal, colour, to_camera;
  Real pixel;  // size of one there, sizes
};

HWY_INLINE SkinLanes skin_lanes(const RasterScene& scene, const SkinSeen& seen, int at) {
  const FurModel& model = *scene.model;
  const Int piece = hn::LoadU(int_tag, reinterpret_cast<const std::int32_t*>(seen.piece + at));
  const Int corners = hn::Mul(piece, whole(3));
  const auto* vertices = reinterpret_cast<const std::int32_t*>(model.triangles.data());
  Vec3 place[3], normal[3], colour[3];
  constexpr int stride = sizeof(FurCorner) / sizeof(float), colour_at = offsetof(FurCorner, colour) / sizeof(float);
  for (int k = 0; k < 3; ++k) {
    const Int vertex = hn::Mul(gather(vertices + k, corners), whole(3));
    place[k] = gather_vec3(&model.positions[0].x, vertex), normal[k] = gather_vec3(&model.normals[0].x, vertex);
    const float* first = reinterpret_cast<const float*>(&model.corners[0][0]) + k * stride + colour_at;
    colour[k] = gather_vec3(first, hn::Mul(corners, whole(stride)));
  }
  const Vec3 way = ray_through(scene.camera, load(seen.x + at), load(seen.y + at));
  const Real distance = 1.0f / max(load(seen.inverse + at), 1e-20f), size = length(way);
  SkinLanes skin;
  skin.place = Vec3(scene.camera.position) + way * distance, skin.to_camera = way * (-1.0f / size);
  skin.pixel = scene.optics.frame.viewpoint.w * distance * size;
  const Vec3 across = cross(place[1] - place[0], place[2] - place[0]);
  const Real square = max(dot(across, across), 1e-30f);
  const Real b = clamp(dot(cross(skin.place - place[0], place[2] - place[0]), across) / square, 0.0f, 1.0f);
  const Real c = clamp(dot(cross(place[1] - place[0], skin.place - place[0]), across) / square, 0.0f, 1.0f - b);
  skin.normal = unit(normal[0] + b * (normal[1] - normal[0]) + c * (normal[2] - normal[0]));
  skin.normal = select(dot(across, way) > 0.0f, -skin.normal, skin.normal);
  skin.colour = colour[0] + b * (colour[1] - colour[0]) + c * (colour[2] - colour[0]);
  return skin;
}

/// Under fur a matt surface with the colour of its roots.
HWY_INLINE Vec3 colour_under_fur(const FrameOptics& optics, const SkinLanes& skin) {
  const FrameBlock& frame = optics.frame;
  Vec3 colour(frame.ramp_root);
  if (optics.model_colours) {
    const Real lightness = luminance(colour) * (1 / frame.tile.w);
    colour = max(skin.colour, 0.0f) * (0.36f + 0.84f * lightness);
  }
  return colour;
}

/// What grows fur and what is bare, each by its share.
HWY_INLINE Vec3 skin_light(const RasterScene& scene, const SkinLanes& skin) {
  const FrameOptics& optics = scene.optics;
  const FrameBlock& frame = optics.frame;
  const Vec3 colour = colour_under_fur(optics, skin);
  Bare bare = not_bare();
  if (optics.skin.count.x > 0) bare = bare_over(optics.skin, bare, skin.place, skin.normal, skin.pixel);
  const bool shows_bare = any(bare.share > 0.0f);
  const SkinSurface surface = skin_surface(bare, skin.place, skin.normal, skin.to_camera, skin.pixel);
  const Real above = frame.depth_above[0].x;
  const Vec3 crossed = colour * Vec3(frame.colour_above[0]);
  const Vec3 stopped = stopped_by_strand(crossed, 1.0f, frame.exponents.w);
  Vec3 sum = frame.weights.x * colour * environment_light(optics, skin.normal) *
             ambient_share(frame, 0.0f, above, stopped_by_strand(crossed, 0.6f, frame.exponents.w));
  if (shows_bare) sum = mix(sum, sky_on_skin(optics, bare, surface), bare.share);
  const GridPlace& grid = scene.grid->place();
  const GridLanes cells = grid_lanes(grid, skin.place + skin.normal * (off_skin * grid.cell));
  Real between[4];
  for (int i = 0; i < optics.lights; ++i) {
    if (i % 2 == 0) crossed_by_two(scene.grid->crossed(static_cast<std::size_t>(i / 2)), cells, between);
    const Arriving light = light_at(optics, i, skin.place);
    const Real strands = between[2 * (i % 2)], body = between[2 * (i % 2) + 1];
    const Vec3 through = each(stopped, [=](Real s) HWY_ATTR { return exp2(-1.442695f * mul_add(strands, s, body)); });
    Vec3 sent = colour * (frame.weights.y * max(dot(skin.normal, light.to_light), 0.0f));
    if (shows_bare) sent = mix(sent, light_on_skin(optics, bare, surface, light.to_light), bare.share);
    sum += light.radiance * through * sent;
  }
  return sum;
}

HWY_INLINE void light_seen(const RasterScene& scene, SkinSeen& seen, int at) {
  const Vec3 light = skin_light(scene, skin_lanes(scene, seen, at));
  store(light.x, seen.red + at), store(light.y, seen.green + at), store(light.z, seen.blue + at);
}

}  // namespace pelage::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
