// The surface of bare skin. The includer defines SkinEntry, a region in the block of bare skin, and point_in_cell,
// which gives a point in [0, 1]^3 for each integer cell.

struct Bare {
  Vec3 colour;
  Real shine, roughness, wetness, bump_height, bump_size, scatter;
  Real share;  // share of the surface here that is bare, [0, 1]
};

// Skin for shading: the normals of its relief, and of the wet film that partly fills the relief.
struct SkinSurface {
  Vec3 to_camera, normal, film, colour;
  Real visibility;  // factor on light: 1, less in creases
  Real dry_roughness, wet_roughness;
};

// Relief of domed cells with creases between them.
struct Leather {
  Vec3 slope;    // gradient of the height, in cells
  Real visibility;  // 0 at the bottom of a crease, 1 outside
};

// Returns skin that is painted bare, in the given colour. It fades out where fur has about half of its length.
FUNCTION Bare painted_bare(Vec3 colour, Real painted, Real wetness) {
  Bare bare;
  bare.colour = colour;
  bare.shine = bare.roughness = bare.scatter = Real(0.5f);
  bare.wetness = wetness;
  bare.bump_height = Real(0.0004f);
  bare.bump_size = Real(0.004f);
  bare.share = smoothstep(0.3f, 0.7f, painted);
  return bare;
}

// Returns the share of a region's look at a position. It fades out over half of the softness, where fur has about half
// of its length, but over at least two pixels; of regions smaller than a pixel, within twice their radii.
FUNCTION Real bare_share(SkinEntry region, Vec3 position, Vec3 normal, Real pixel) {
  Vec3 apart = position - Vec3(region.centre);
  Real off = length(Vec3(dot(Vec3(region.across), apart), dot(Vec3(region.up), apart), dot(Vec3(region.along), apart)));
  Real edge = max(0.5f * region.across.w, min(2.0f * region.up.w * pixel + 1e-6f, 1.0f));
  return (1.0f - smoothstep(1.0f, 1.0f + edge, off)) *
         smoothstep(region.facing.w, region.along.w, dot(normal, Vec3(region.facing)));
}

// Returns the relief at a position. Creases lie where the two nearest points are equally near (Worley 1996).
FUNCTION Leather leather(Vec3 at) {
  Vec3 middle = floor(at), first = Vec3(9.0f), second = Vec3(9.0f);
  for (int k = 0; k < 27; ++k) {
    Vec3 cell = middle + Vec3(float(k % 3 - 1), float(k / 3 % 3 - 1), float(k / 9 - 1));
    Vec3 apart = at - cell - point_in_cell(cell);
    Real square = dot(apart, apart);
    Mask nearest = square < dot(first, first), next = square < dot(second, second);
    second = select(nearest, first, select(next, apart, second));
    first = select(nearest, apart, first);
  }
  float crease = 0.55f;
  Real off = clamp((length(second) - length(first)) / crease, 0.0f, 1.0f);
  Vec3 away = second * (1.0f / max(length(second), 1e-6f)) - first * (1.0f / max(length(first), 1e-6f));
  Leather relief;
  relief.slope = away * (6.0f / crease * off * (1.0f - off)) - 2.0f * first;
  relief.visibility = off * off * (3.0f - 2.0f * off);
  return relief;
}

// Returns Schlick's reflectance, from f0 up to f0 + rise.
FUNCTION Real schlick(Real f0, Real rise, Real facing) {
  Real away = 1.0f - facing, square = away * away;
  return f0 + rise * square * square * away;
}

// Returns Blinn's highlight, with the same energy at any width, times Schlick's reflectance. Lights are not points, so
// no highlight is narrower than at roughness 0.15.
FUNCTION Real skin_highlight(Vec3 normal, Vec3 to_light, Vec3 to_camera, Real f0, Real roughness) {
  Vec3 between = unit_or_zero(to_light + to_camera);
  Real rough = max(roughness, 0.15f), alpha = rough * rough, exponent = 2.0f / (alpha * alpha) - 2.0f;
  Real fresnel = schlick(f0, 1.0f - f0, clamp(dot(between, to_camera), 0.0f, 1.0f));
  Real lobe = (exponent + 8.0f) * 0.125f * pow(max(dot(normal, between), 1e-6f), exponent);
  return fresnel * lobe * max(dot(normal, to_light), 0.0f);
}

FUNCTION SkinSurface skin_surface(Bare bare, Vec3 position, Vec3 normal, Vec3 to_camera, Real pixel) {
  Real size = max(bare.bump_size, 1e-4f);
  Real seen = smoothstep(3.0f, 8.0f, size / max(pixel, 1e-9f));  // small cells would sparkle; they widen highlights
  Real full_height = min(bare.bump_height / size, 4.0f), steep = seen * full_height;
  Leather relief;
  relief.slope = Vec3(0.0f);
  relief.visibility = Real(1.0f);
  if (any_lane(steep > 0.0f)) relief = leather(position * (1.0f / size));
  Vec3 slope = relief.slope - dot(relief.slope, normal) * normal;
  Real uneven = 1.0f - 0.7f * bare.wetness, lost = full_height - steep;
  float film_roughness = 0.28f;  // of the wet film; lower values sparkle
  SkinSurface surface;
  surface.to_camera = to_camera;
  surface.normal = unit_or_zero(normal - steep * slope);
  surface.film = unit_or_zero(normal - uneven * steep * slope);
  surface.colour = bare.colour * (1.0f - 0.4f * bare.wetness);
  surface.visibility = mix(1.0f, relief.visibility, min(2.0f * steep, 0.6f));
  surface.dry_roughness = min(bare.roughness + lost, 1.0f);
  surface.wet_roughness = min(film_roughness + uneven * lost, 1.0f);
  return surface;
}
