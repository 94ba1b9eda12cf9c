// Lighting of the skin between strands. Reads the same as grid_shadow.glsl; grid_there says whether anything occludes
// light.

// A visible position on the skin.
struct SkinPoint {
  Vec3 position, normal, to_camera;
  Vec3 colour;  // colour where no fur grows
  Vec3 under;   // colour under fur
  Real grown, bare, wetness;
  Real pixel;  // size of a pixel there, sizes
};

// The look of skin with fur, and of bare skin.
struct SkinLooks {
  Vec3 furred;  // colour
  Bare bare;
};

FUNCTION SkinLooks skin_looks(SkinPoint skin) {
  SkinLooks looks;
  looks.furred = mix(skin.colour, skin.under, skin.grown);
  looks.bare = painted_bare(skin.colour, skin.bare, skin.wetness);
  if (bare_skin.count.x > 0) looks.bare = bare_over(looks.bare, skin.position, skin.normal, skin.pixel);
  return looks;
}

FUNCTION Vec3 skin_albedo(SkinLooks looks) { return mix(looks.furred, looks.bare.colour, looks.bare.share); }

FUNCTION SentLight skin_light(SkinPoint skin, SkinLooks looks, bool unshadowed) {
  Bare bare = looks.bare;
  bool shows_bare = any_lane(bare.share > 0.0f);
  SkinSurface surface = skin_surface(bare, skin.position, skin.normal, skin.to_camera, skin.pixel);
  Real above = Real(frame.depth_above[0].x);
  Vec3 crossed = looks.furred * Vec3(frame.colour_above[0]), stopped = stopped_by_strand(crossed, 1.0f);
  SentLight sum;
  sum.ambient = frame.weights.x * looks.furred * environment_light(skin.normal);
  if (grid_there) sum.ambient *= ambient_share(Real(0.0f), above, stopped_by_strand(crossed, 0.6f));
  sum.direct = sum.unshadowed = Vec3(0.0f);
  if (shows_bare) sum.ambient = mix(sum.ambient, sky_on_skin(bare, surface), bare.share);
  GridCells cells;
  if (grid_there) cells = cells_off_skin(skin.position, skin.normal);
  for (Index i = 0; i < light_count; ++i) {
    Arriving light = light_at(i, skin.position);
    Vec3 through = Vec3(1.0f);
    if (grid_there) through = transmittance_of(crossed_at(i, cells), stopped);
    Vec3 sent = looks.furred * (frame.weights.y * max(dot(skin.normal, light.to_light), 0.0f));
    if (shows_bare) sent = mix(sent, light_on_skin(bare, surface, light.to_light), bare.share);
    sum.direct += light.radiance * sent * through;
    if (unshadowed) sum.unshadowed += light.radiance * sent;
  }
  return sum;
}
