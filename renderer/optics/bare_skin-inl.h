// Bare skin: regions with a look of their own (protocol/commands/creature.h), and what is painted bare. The twin of
// renderer/shaders/bare_skin.glsl, which has the sources.
#if defined(PELAGE_OPTICS_BARE_SKIN_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef PELAGE_OPTICS_BARE_SKIN_INL_H_
#undef PELAGE_OPTICS_BARE_SKIN_INL_H_
#else
#define PELAGE_OPTICS_BARE_SKIN_INL_H_
#endif

#include "renderer/optics/light-inl.h"

HWY_BEFORE_NAMESPACE();
namespace pelage::HWY_NAMESPACE {

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

}  // namespace pelage::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
