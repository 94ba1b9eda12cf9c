// Light of the skin between strands, a pixel a lane.
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

// Bare skin: regions with a look of their own (protocol/commands/creature.h), and what is painted bare. The twin of
// renderer/shaders/bare_skin.glsl, which has the sources.

struct Bare {
  Vec3 colour;
  Real shine, roughness, wetness, bump_height, bump_size, scatter;
  Real share;  // of what is seen here that is bare
};

/// Skin that is painted bare: of the scene's colour. It ends where fur has about half of its length.
HWY_INLINE Bare painted_bare(Vec3 colour, Real bare, Real wetness) {
  return {colour, 0.5f, 0.5f, wetness, 0.0004f, 0.004f, 0.5f, smoothstep(0.3f, 0.7f, bare)};
}

/// The colour ends where fur has about half of its length, or within two pixels where that is sharper.
HWY_INLINE Real bare_share(const SkinEntry& region, Vec3 place, Vec3 normal, Real pixel) {
  const Vec3 apart = place - Vec3(region.centre);
  const Real off =
      length(Vec3(dot(Vec3(region.across), apart), dot(Vec3(region.up), apart), dot(Vec3(region.along), apart)));
  const Real edge = max(0.5f * region.across.w, min(2.0f * region.up.w * pixel + 1e-6f, 1.0f));
  return (1.0f - smoothstep(1.0f, 1.0f + edge, off)) *
         smoothstep(region.facing.w, region.along.w, dot(normal, Vec3(region.facing)));
}

/// All regions at a place, each over those before it and over what is bare without them.
HWY_INLINE Bare bare_over(const SkinBlock& skin, Bare bare, Vec3 place, Vec3 normal, Real pixel) {
  for (std::size_t i = 0; i < skin.count.x; ++i) {
    const Vec3 apart = place - Vec3(skin.balls[i]);
    if (!any(dot(apart, apart) <= skin.balls[i].w)) continue;  // so that most of the body costs little
    const SkinEntry& region = skin.regions[i];
    const Real share = bare_share(region, place, normal, pixel);
    bare.share = 1.0f - (1.0f - bare.share) * (1.0f - share);
    const Real over = share / max(bare.share, 1e-9f);
    bare.colour = mix(bare.colour, Vec3(region.colour), over), bare.shine = mix(bare.shine, region.colour.w, over);
    bare.roughness = mix(bare.roughness, region.finish.x, over),
    bare.wetness = mix(bare.wetness, region.finish.y, over);
    bare.bump_height = mix(bare.bump_height, region.finish.z, over);
    bare.bump_size = select(over >= 0.5f, region.finish.w, bare.bump_size);
    bare.scatter = mix(bare.scatter, region.centre.w, over);
  }
  return bare;
}

/// A point in a cell: pcg3d (Jarzynski and Olano 2020).
HWY_INLINE Vec3 point_in_cell(Int x, Int y, Int z) {
  const auto seeded = [](Int v) HWY_ATTR { return hn::Add(hn::Mul(v, whole(1664525)), whole(1013904223)); };
  const auto mixed = [](Int v, Int a, Int b) HWY_ATTR { return hn::Add(v, hn::Mul(a, b)); };
  const auto folded = [](Int v) HWY_ATTR {
    const hn::RebindToUnsigned<IntTag> bits;
    return hn::Xor(v, hn::BitCast(int_tag, hn::ShiftRight<16>(hn::BitCast(bits, v))));
  };
  x = seeded(x), y = seeded(y), z = seeded(z);
  x = mixed(x, y, z), y = mixed(y, z, x), z = mixed(z, x, y);
  x = folded(x), y = folded(y), z = folded(z);
  x = mixed(x, y, z), y = mixed(y, z, x), z = mixed(z, x, y);
  const auto share = [](Int v) HWY_ATTR {
    const hn::RebindToUnsigned<IntTag> bits;
    return to_real(hn::BitCast(int_tag, hn::ShiftRight<8>(hn::BitCast(bits, v)))) * (1.0f / 16777216);
  };
  return {share(x), share(y), share(z)};
}

/// Domed cells with creases between them, where the two nearest points are as near (Worley 1996).
struct Leather {
  Vec3 slope;    // in cells
  Real creased;  // how far the crease is left behind, 0 at its bottom
};

HWY_INLINE Leather leather(Vec3 at) {
  const Int x = to_int(floor(at.x)), y = to_int(floor(at.y)), z = to_int(floor(at.z));
  Vec3 first(9.0f), second(9.0f);
  for (int k = 0; k < 27; ++k) {
    const Int i = hn::Add(x, whole(k % 3 - 1)), j = hn::Add(y, whole(k / 3 % 3 - 1)), l = hn::Add(z, whole(k / 9 - 1));
    const Vec3 apart = at - Vec3(to_real(i), to_real(j), to_real(l)) - point_in_cell(i, j, l);
    const Real square = dot(apart, apart);
    const Mask nearest = square < dot(first, first), next = square < dot(second, second);
    second = select(nearest, first, select(next, apart, second));
    first = select(nearest, apart, first);
  }
  const float crease = 0.55f;
  const Real off = clamp((length(second) - length(first)) * (1 / crease), 0.0f, 1.0f);
  const Vec3 away = second * (1.0f / max(length(second), 1e-6f)) - first * (1.0f / max(length(first), 1e-6f));
  return {away * (6.0f / crease * off * (1.0f - off)) - 2.0f * first, off * off * (3.0f - 2.0f * off)};
}

/// Blinn's highlight, its energy the same at any width, and Schlick's reflectance.
HWY_INLINE Real skin_highlight(Vec3 normal, Vec3 to_light, Vec3 to_camera, Real f0, Real roughness) {
  const Vec3 between = unit_or_zero(to_light + to_camera);
  const Real rough = max(roughness, 0.15f), alpha = rough * rough, exponent = 2.0f / (alpha * alpha) - 2.0f;
  const Real away = 1.0f - clamp(dot(between, to_camera), 0.0f, 1.0f), square = away * away;
  const Real fresnel = f0 + (1.0f - f0) * square * square * away;
  const Real lobe = (exponent + 8.0f) * 0.125f * pow(max(dot(normal, between), 1e-6f), exponent);
  return fresnel * lobe * max(dot(normal, to_light), 0.0f);
}

/// What the surroundings send along a mirrored ray: a soft sky over a darker ground.
HWY_INLINE Vec3 mirrored_sky(const FrameOptics& optics, Vec3 normal, Vec3 to_camera, Real f0, Real roughness) {
  const Real facing = max(dot(normal, to_camera), 0.0f);
  const Vec3 way = 2.0f * facing * normal - to_camera;
  const Real spread = mix(0.25f, 1.5f, roughness), sky = mix(0.25f, 1.15f, smoothstep(-spread, spread, way.y));
  const Real away = 1.0f - facing, square = away * away;
  const Real mirrored = f0 + max(1.0f - roughness - f0, 0.0f) * square * square * away;
  return optics.frame.weights.x * environment_light(optics, way) * (sky * mirrored);
}

/// Bare skin as the light finds it: normals of the relief, and of the wet film that partly fills it.
struct SkinSurface {
  Vec3 to_camera, normal, film, colour;
  Real open;  // 0 in the depth of a crease
  Real dry_roughness, wet_roughness;
};

HWY_INLINE SkinSurface skin_surface(const Bare& bare, Vec3 place, Vec3 normal, Vec3 to_camera, Real pixel) {
  const Real size = max(bare.bump_size, 1e-4f);
  const Real seen = smoothstep(3.0f, 8.0f, size / max(pixel, 1e-9f));  // finer cells widen highlights instead
  const Real whole_height = min(bare.bump_height / size, 4.0f), steep = seen * whole_height;
  Leather relief{Vec3(0.0f), 1.0f};
  if (any(steep > 0.0f)) relief = leather(place * (1.0f / size));
  const Vec3 slope = relief.slope - dot(relief.slope, normal) * normal;
  const Real uneven = 1.0f - 0.7f * bare.wetness, lost = whole_height - steep;
  const float film_roughness = 0.28f;  // glints, not sparks
  return {to_camera,
          unit(normal - steep * slope),
          unit(normal - uneven * steep * slope),
          bare.colour * (1.0f - 0.4f * bare.wetness),
          mix(1.0f, relief.creased, min(2.0f * steep, 0.6f)),
          min(bare.roughness + lost, 1.0f),
          min(film_roughness + uneven * lost, 1.0f)};
}

HWY_INLINE Vec3 light_on_skin(const FrameOptics& optics, const Bare& bare, const SkinSurface& surface, Vec3 to_light) {
  const Real cosine = dot(surface.normal, to_light);
  const auto wrapped = [&](float part) HWY_ATTR {
    const Real wrap = bare.scatter * part;
    return max((cosine + wrap) / (1.0f + wrap), 0.0f);
  };
  const Vec3 diffuse =
      optics.frame.weights.y * surface.open * surface.colour * Vec3(wrapped(0.45f), wrapped(0.20f), wrapped(0.14f));
  const Real skin =
      skin_highlight(surface.normal, to_light, surface.to_camera, 0.08f * bare.shine, surface.dry_roughness);
  const Real film = skin_highlight(surface.film, to_light, surface.to_camera, 0.03f, surface.wet_roughness);
  return diffuse + Vec3(surface.open * mix(select(bare.shine > 0.0f, skin, 0.0f), film, bare.wetness));
}

/// What bare skin sends to the camera of the light from all around.
HWY_INLINE Vec3 sky_on_skin(const FrameOptics& optics, const Bare& bare, const SkinSurface& surface) {
  const Vec3 sum = optics.frame.weights.x * surface.open * surface.colour * environment_light(optics, surface.normal);
  const Vec3 dry = mirrored_sky(optics, surface.normal, surface.to_camera, 0.08f * bare.shine, surface.dry_roughness);
  const Vec3 wet = mirrored_sky(optics, surface.film, surface.to_camera, 0.03f, surface.wet_roughness);
  return sum + surface.open * mix(select(bare.shine > 0.0f, dry, Vec3(0.0f)), wet, bare.wetness);
}

HWY_INLINE Vec3 gather_vec3(const float* from, Int index) {
  return {gather(from, index), gather(from + 1, index), gather(from + 2, index)};
}

/// Numbers of the three corners of each lane's piece, which lie `stride` floats apart, and how they are mixed there.
struct PieceCorners {
  Int piece;
  Real b, c;  // shares of the second and the third

  HWY_INLINE Real mix(const float* first, int stride) const {
    const Int at = hn::Mul(piece, whole(3 * stride));
    const Real a = gather(first, at);
    return a + b * (gather(first + stride, at) - a) + c * (gather(first + 2 * stride, at) - a);
  }
  HWY_INLINE Vec3 mix3(const float* first, int stride) const {
    return {mix(first, stride), mix(first + 1, stride), mix(first + 2, stride)};
  }
};

/// The skin where it is seen.
struct SkinLanes {
  Vec3 place, normal, to_camera;
  Vec3 colour;  // of what no fur hides
  Vec3 under;   // under fur
  Real grown, bare, wetness;
  Real pixel;  // size of one that is seen there, sizes
  PieceCorners corners;
};

inline constexpr int corner_stride = sizeof(FurCorner) / sizeof(float), look_stride = sizeof(SkinLook) / sizeof(float);

HWY_INLINE const float* corner_floats(const FurModel& model, std::size_t offset) {
  return reinterpret_cast<const float*>(reinterpret_cast<const char*>(model.corners.data()) + offset);
}

/// The model's own colour; `pixel` is the size of one there, sizes, and `area` twice that of the piece.
HWY_INLINE Vec3 own_colour(const RasterScene& scene, const PieceCorners& corners, Real pixel, Real area) {
  const FrameOptics& optics = scene.optics;
  if (!optics.model_colours) return Vec3(optics.frame.skin);
  const FurModel& model = *scene.model;
  const Vec3 colour = max(corners.mix3(corner_floats(model, offsetof(FurCorner, colour)), corner_stride), 0.0f);
  if (!optics.images) return colour;
  const float* uv = corner_floats(model, offsetof(FurCorner, image_uv));
  const Int at = hn::Mul(corners.piece, whole(3 * corner_stride));
  const auto side = [&](int k, int axis)
                        HWY_ATTR { return gather(uv + k * corner_stride + axis, at) - gather(uv + axis, at); };
  const Real on_image = abs(side(1, 0) * side(2, 1) - side(1, 1) * side(2, 0));
  const auto* image = reinterpret_cast<const std::int32_t*>(corner_floats(model, offsetof(FurCorner, image)));
  const Vec3 where{corners.mix(uv, corner_stride), corners.mix(uv + 1, corner_stride), to_real(gather(image, at))};
  return colour * image_colour(*optics.images, where, pixel * sqrt(on_image / max(area, 1e-20f)));
}

HWY_INLINE SkinLanes skin_lanes(const RasterScene& scene, const SkinSeen& seen, int at) {
  const FurModel& model = *scene.model;
  PieceCorners corners;
  corners.piece = hn::LoadU(int_tag, reinterpret_cast<const std::int32_t*>(seen.piece + at));
  const Int first = hn::Mul(corners.piece, whole(3));
  const auto* vertices = reinterpret_cast<const std::int32_t*>(model.triangles.data());
  Vec3 place[3], normal[3];
  for (int k = 0; k < 3; ++k) {
    const Int vertex = hn::Mul(gather(vertices + k, first), whole(3));
    place[k] = gather_vec3(&model.positions[0].x, vertex), normal[k] = gather_vec3(&model.normals[0].x, vertex);
    const float* shading = corner_floats(model, offsetof(FurCorner, normal)) + k * corner_stride;
    const Vec3 other = gather_vec3(shading, hn::Mul(corners.piece, whole(3 * corner_stride)));
    normal[k] = select(dot(other, other) > 0.0f, other, normal[k]);
  }
  const Vec3 way = ray_through(scene.camera, load(seen.x + at), load(seen.y + at));
  const Real distance = 1.0f / max(load(seen.inverse + at), 1e-20f), size = length(way);
  SkinLanes skin;
  skin.place = Vec3(scene.camera.position) + way * distance, skin.to_camera = way * (-1.0f / size);
  skin.pixel = scene.optics.frame.viewpoint.w * scene.oversampling * distance * size;
  const Vec3 across = cross(place[1] - place[0], place[2] - place[0]);
  const Real square = max(dot(across, across), 1e-30f);
  corners.b = clamp(dot(cross(skin.place - place[0], place[2] - place[0]), across) / square, 0.0f, 1.0f);
  corners.c = clamp(dot(cross(place[1] - place[0], skin.place - place[0]), across) / square, 0.0f, 1.0f - corners.b);
  skin.normal = unit(normal[0] + corners.b * (normal[1] - normal[0]) + corners.c * (normal[2] - normal[0]));
  skin.normal = select(dot(across, way) > 0.0f, -skin.normal, skin.normal);
  skin.colour = own_colour(scene, corners, skin.pixel, sqrt(square));
  static_assert(sizeof(SkinLook) == 6 * sizeof(float));
  const float* look = &scene.skin[0][0].under.x;
  skin.under = corners.mix3(look, look_stride), skin.grown = corners.mix(look + 3, look_stride);
  skin.bare = corners.mix(look + 4, look_stride), skin.wetness = corners.mix(look + 5, look_stride);
  skin.corners = corners;
  return skin;
}

/// What of the skin grows fur, and what is bare.
struct SkinLooks {
  Vec3 furred;  // colour
  Bare bare;

  HWY_INLINE Vec3 albedo() const { return mix(furred, bare.colour, bare.share); }
};

HWY_INLINE SkinLooks skin_looks(const FrameOptics& optics, const SkinLanes& skin) {
  SkinLooks looks{mix(skin.colour, skin.under, skin.grown), painted_bare(skin.colour, skin.bare, skin.wetness)};
  if (optics.skin.count.x > 0) looks.bare = bare_over(optics.skin, looks.bare, skin.place, skin.normal, skin.pixel);
  return looks;
}

/// Of a light, what strands and the body let through to each lane's place.
class WayToSkin {
 public:
  HWY_INLINE WayToSkin(const RasterScene& scene, const SkinLanes& skin, Vec3 stopped)
      : grid_(scene.grid), stopped_(stopped) {
    if (!grid_) return;
    const GridPlace& place = grid_->place();
    cells_ = grid_lanes(place, skin.place + skin.normal * (off_skin * place.cell));
  }
  HWY_INLINE Vec3 through(int light) const {
    if (!grid_) return Vec3(1.0f);
    return let_through(crossed_at(grid_->crossed(static_cast<std::size_t>(light)), cells_), stopped_);
  }

 private:
  const DensityGrid* grid_;
  Vec3 stopped_;
  GridLanes cells_;
};

template <bool unshadowed>
HWY_INLINE SentLight skin_light(const RasterScene& scene, const SkinLanes& skin, const SkinLooks& looks) {
  const FrameOptics& optics = scene.optics;
  const FrameBlock& frame = optics.frame;
  const Bare& bare = looks.bare;
  const bool shows_bare = any(bare.share > 0.0f);
  const SkinSurface surface = skin_surface(bare, skin.place, skin.normal, skin.to_camera, skin.pixel);
  const Real above = frame.depth_above[0].x;
  const Vec3 crossed = looks.furred * Vec3(frame.colour_above[0]);
  const Vec3 stopped = stopped_by_strand(crossed, 1.0f, frame.exponents.w);
  SentLight sum;
  sum.ambient = frame.weights.x * looks.furred * environment_light(optics, skin.normal);
  if (scene.grid) sum.ambient *= ambient_share(frame, 0.0f, above, stopped_by_strand(crossed, 0.6f, frame.exponents.w));
  sum.direct = sum.unshadowed = Vec3(0.0f);
  if (shows_bare) sum.ambient = mix(sum.ambient, sky_on_skin(optics, bare, surface), bare.share);
  const WayToSkin way(scene, skin, stopped);
  for (int i = 0; i < optics.lights; ++i) {
    const Arriving light = light_at(optics, i, skin.place);
    const Vec3 through = way.through(i);
    Vec3 sent = looks.furred * (frame.weights.y * max(dot(skin.normal, light.to_light), 0.0f));
    if (shows_bare) sent = mix(sent, light_on_skin(optics, bare, surface, light.to_light), bare.share);
    sum.direct += light.radiance * sent * through;
    if constexpr (unshadowed) sum.unshadowed += light.radiance * sent;
  }
  return sum;
}

/// What the scene shows of the skin.
HWY_INLINE Vec3 shown_of(const RasterScene& scene, const SkinLanes& skin, Real inverse) {
  const Real none = 0.0f;
  switch (scene.shown) {
    case RasterOutput::distance: return {1.0f / max(inverse, 1e-12f), none, none};
    case RasterOutput::depth: return {inverse, none, none};
    case RasterOutput::normal: return skin.normal;
    case RasterOutput::piece: return {to_real(skin.corners.piece), none, none};
    case RasterOutput::field: return field_at(scene, skin.corners.piece, skin.corners.b, skin.corners.c);
    case RasterOutput::tangent:
    case RasterOutput::count:
    case RasterOutput::strand: return Vec3(none);
    default: break;
  }
  const SkinLooks looks = skin_looks(scene.optics, skin);
  switch (scene.shown) {
    case RasterOutput::albedo: return looks.albedo();
    case RasterOutput::direct: return skin_light<false>(scene, skin, looks).direct;
    case RasterOutput::shadow: return skin_light<true>(scene, skin, looks).shadow();
    default: break;
  }
  const SentLight light = skin_light<false>(scene, skin, looks);
  return light.ambient + light.direct;
}

HWY_INLINE void light_seen(const RasterScene& scene, SkinSeen& seen, int at) {
  const Vec3 shown = shown_of(scene, skin_lanes(scene, seen, at), load(seen.inverse + at));
  store(shown.x, seen.red + at), store(shown.y, seen.green + at), store(shown.z, seen.blue + at);
}

}  // namespace pelage::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
