// Shades the skin between strands, one pixel in each lane.
#if defined(PELAGE_RASTER_SKIN_LIGHT_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef PELAGE_RASTER_SKIN_LIGHT_INL_H_
#undef PELAGE_RASTER_SKIN_LIGHT_INL_H_
#else
#define PELAGE_RASTER_SKIN_LIGHT_INL_H_
#endif

#include <cstddef>

#include "renderer/optics/colours-inl.h"
#include "renderer/raster/pixel_rays-inl.h"
#include "renderer/raster/strand_light-inl.h"

HWY_BEFORE_NAMESPACE();
namespace pelage::HWY_NAMESPACE {

HWY_INLINE Vec3 gather_vec3(const float* from, Int index) {
  return {gather(from, index), gather(from + 1, index), gather(from + 2, index)};
}

/// A position on a triangle of the model in each lane. mix() interpolates values of the three corners, which lie
/// `stride` floats apart from `first` on.
struct TriangleCorners {
  Int triangle;  // triangle of the model
  Real b, c;     // barycentrics of the second and the third corner

  HWY_INLINE Real mix(const float* first, int stride) const {
    const Int at = hn::Mul(triangle, splat(3 * stride));
    const Real a = gather(first, at);
    return a + b * (gather(first + stride, at) - a) + c * (gather(first + 2 * stride, at) - a);
  }
  HWY_INLINE Vec3 mix3(const float* first, int stride) const {
    return {mix(first, stride), mix(first + 1, stride), mix(first + 2, stride)};
  }
};

/// The visible point of the skin in each lane.
struct SkinLanes {
  SceneLight::SkinPoint at;
  TriangleCorners corners;
};

inline constexpr int corner_stride = sizeof(FurCorner) / sizeof(float), look_stride = sizeof(SkinLook) / sizeof(float);

HWY_INLINE const float* corner_floats(const FurModel& model, std::size_t offset) {
  return reinterpret_cast<const float*>(reinterpret_cast<const char*>(model.corners.data()) + offset);
}

/// Returns the model's own colour. `pixel` is the size of a pixel there, sizes, and `area` twice the triangle's area.
HWY_INLINE Vec3 own_colour(const RasterScene& scene, const TriangleCorners& corners, Real pixel, Real area) {
  const FrameOptics& optics = scene.optics;
  if (!optics.model_colours) return Vec3(optics.frame.skin);
  const FurModel& model = *scene.model;
  const Vec3 colour = max(corners.mix3(corner_floats(model, offsetof(FurCorner, colour)), corner_stride), 0.0f);
  if (!optics.images) return colour;
  const float* uv = corner_floats(model, offsetof(FurCorner, image_uv));
  const Int at = hn::Mul(corners.triangle, splat(3 * corner_stride));
  const auto side = [&](int k, int axis)
                        HWY_ATTR { return gather(uv + k * corner_stride + axis, at) - gather(uv + axis, at); };
  const Real on_image = abs(side(1, 0) * side(2, 1) - side(1, 1) * side(2, 0));
  const auto* image = reinterpret_cast<const std::int32_t*>(corner_floats(model, offsetof(FurCorner, image)));
  const Vec3 where{corners.mix(uv, corner_stride), corners.mix(uv + 1, corner_stride), to_real(gather(image, at))};
  return colour * image_colour(*optics.images, where, pixel * sqrt(on_image / max(area, 1e-20f)));
}

HWY_INLINE SkinLanes skin_lanes(const RasterScene& scene, const SkinSeen& seen, int at) {
  const FurModel& model = *scene.model;
  TriangleCorners corners;
  corners.triangle = hn::LoadU(int_tag, reinterpret_cast<const std::int32_t*>(seen.triangle + at));
  const Int first = hn::Mul(corners.triangle, splat(3));
  const auto* vertices = reinterpret_cast<const std::int32_t*>(model.triangles.data());
  Vec3 positions[3], normal[3];
  for (int k = 0; k < 3; ++k) {
    const Int vertex = hn::Mul(gather(vertices + k, first), splat(3));
    positions[k] = gather_vec3(&model.positions[0].x, vertex), normal[k] = gather_vec3(&model.normals[0].x, vertex);
    const float* shading = corner_floats(model, offsetof(FurCorner, normal)) + k * corner_stride;
    const Vec3 other = gather_vec3(shading, hn::Mul(corners.triangle, splat(3 * corner_stride)));
    normal[k] = select(dot(other, other) > 0.0f, other, normal[k]);
  }
  const Vec3 ray = ray_through(scene.camera, load(seen.x + at), load(seen.y + at));
  const Real distance = 1.0f / max(load(seen.inverse + at), 1e-20f), size = length(ray);
  SceneLight::SkinPoint skin;
  skin.position = Vec3(scene.camera.position) + ray * distance, skin.to_camera = ray * (-1.0f / size);
  skin.pixel = scene.optics.frame.viewpoint.w * scene.oversampling * distance * size;
  const Vec3 across = cross(positions[1] - positions[0], positions[2] - positions[0]);
  const Real square = max(dot(across, across), 1e-30f);
  corners.b = clamp(dot(cross(skin.position - positions[0], positions[2] - positions[0]), across) / square, 0.0f, 1.0f);
  corners.c = clamp(dot(cross(positions[1] - positions[0], skin.position - positions[0]), across) / square, 0.0f,
                    1.0f - corners.b);
  skin.normal = unit(normal[0] + corners.b * (normal[1] - normal[0]) + corners.c * (normal[2] - normal[0]));
  skin.normal = select(dot(across, ray) > 0.0f, -skin.normal, skin.normal);
  skin.colour = own_colour(scene, corners, skin.pixel, sqrt(square));
  static_assert(sizeof(SkinLook) == 6 * sizeof(float));
  const float* look = &scene.skin[0][0].under.x;
  skin.under = corners.mix3(look, look_stride), skin.grown = corners.mix(look + 3, look_stride);
  skin.bare = corners.mix(look + 4, look_stride), skin.wetness = corners.mix(look + 5, look_stride);
  return {skin, corners};
}

/// Returns what the scene shows of the skin.
HWY_INLINE Vec3 output_value(const RasterScene& scene, const SkinLanes& skin, Real inverse) {
  const Real none = 0.0f;
  switch (scene.output) {
    case RasterOutput::distance: return {1.0f / max(inverse, 1e-12f), none, none};
    case RasterOutput::depth: return {inverse, none, none};
    case RasterOutput::normal: return skin.at.normal;
    case RasterOutput::triangle: return {to_real(skin.corners.triangle), none, none};
    case RasterOutput::field: return field_at(scene, skin.corners.triangle, skin.corners.b, skin.corners.c);
    case RasterOutput::objects: return object_mask(scene, skin_object);
    case RasterOutput::tangent:
    case RasterOutput::count:
    case RasterOutput::strand: return Vec3(none);
    default: break;
  }
  SceneLight from(scene);
  const SceneLight::SkinLooks looks = from.skin_looks(skin.at);
  if (scene.output == RasterOutput::albedo) return from.skin_albedo(looks);
  return light_output(scene, from.skin_light(skin.at, looks, scene.output == RasterOutput::shadow));
}

HWY_INLINE void light_seen(const RasterScene& scene, SkinSeen& seen, int at) {
  const Vec3 output = output_value(scene, skin_lanes(scene, seen, at), load(seen.inverse + at));
  store(output.x, seen.red + at), store(output.y, seen.green + at), store(output.z, seen.blue + at);
}

}  // namespace pelage::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
