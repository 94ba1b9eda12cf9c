// The shading of bare skin: regions with a look of their own (protocol/commands/creature.h), and skin that is painted
// bare. Reads the blocks `frame` and `bare_skin`.

// Blends all regions at a position over `bare`, each over those before it. `pixel` is the size of a pixel there.
FUNCTION Bare bare_over(Bare bare, Vec3 position, Vec3 normal, Real pixel) {
  for (Index i = 0; i < bare_skin.count.x; ++i) {
    Vec3 apart = position - Vec3(bare_skin.balls[i]);
    if (!any_lane(dot(apart, apart) <= bare_skin.balls[i].w)) continue;  // skips most of the body cheaply
    SkinEntry region = bare_skin.regions[i];
    Real share = bare_share(region, position, normal, pixel);
    bare.share = 1.0f - (1.0f - bare.share) * (1.0f - share);
    Real over = share / max(bare.share, 1e-9f);
    bare.colour = mix(bare.colour, Vec3(region.colour), over);
    bare.shine = mix(bare.shine, region.colour.w, over);
    bare.roughness = mix(bare.roughness, region.finish.x, over);
    bare.wetness = mix(bare.wetness, region.finish.y, over);
    bare.bump_height = mix(bare.bump_height, region.finish.z, over);
    bare.bump_size = select(over >= 0.5f, region.finish.w, bare.bump_size);
    bare.scatter = mix(bare.scatter, region.centre.w, over);
  }
  return bare;
}

// Returns the environment's light along the mirrored view ray: a soft sky over a darker ground.
FUNCTION Vec3 mirrored_sky(Vec3 normal, Vec3 to_camera, Real f0, Real roughness) {
  Real facing = max(dot(normal, to_camera), 0.0f);
  Vec3 reflected = 2.0f * facing * normal - to_camera;
  Real spread = mix(0.25f, 1.5f, roughness), sky = mix(0.25f, 1.15f, smoothstep(-spread, spread, reflected.y));
  return frame.weights.x * environment_light(reflected) * (sky * schlick(f0, max(1.0f - roughness - f0, 0.0f), facing));
}

// Returns the light that bare skin sends to the camera, for a light of radiance 1 from a direction.
FUNCTION Vec3 light_on_skin(Bare bare, SkinSurface surface, Vec3 to_light) {
  Vec3 wrap = bare.scatter * Vec3(0.45f, 0.20f, 0.14f), cosine = Vec3(dot(surface.normal, to_light));
  Vec3 wrapped = max((cosine + wrap) / (Vec3(1.0f) + wrap), 0.0f);
  Real skin = skin_highlight(surface.normal, to_light, surface.to_camera, 0.08f * bare.shine, surface.dry_roughness);
  Real film = skin_highlight(surface.film, to_light, surface.to_camera, 0.03f, surface.wet_roughness);
  Vec3 diffuse = frame.weights.y * surface.visibility * surface.colour * wrapped;
  return diffuse + Vec3(surface.visibility * mix(select(bare.shine > 0.0f, skin, 0.0f), film, bare.wetness));
}

// Returns the same for light from the environment.
FUNCTION Vec3 sky_on_skin(Bare bare, SkinSurface surface) {
  Vec3 sum = frame.weights.x * surface.visibility * surface.colour * environment_light(surface.normal);
  Vec3 dry = mirrored_sky(surface.normal, surface.to_camera, 0.08f * bare.shine, surface.dry_roughness);
  Vec3 wet = mirrored_sky(surface.film, surface.to_camera, 0.03f, surface.wet_roughness);
  return sum + surface.visibility * mix(select(bare.shine > 0.0f, dry, Vec3(0.0f)), wet, bare.wetness);
}
