// Bare skin in the shells' method. Include it after frame.glsl and lighting.glsl.
#include "bare_skin_block.glsl"

// Returns the light that bare skin sends to the camera. `hull` as in fibre_light: the hull of fur that is bared here or
// stands around it does not shade it.
vec3 bare_light(Bare bare, vec3 position, vec4 hull, vec3 normal, float pixel) {
  SkinSurface surface = skin_surface(bare, position, normal, normalize(frame.viewpoint.xyz - position), pixel);
  vec3 sum = sky_on_skin(bare, surface);
  for (uint i = 0; i < LIGHTS; ++i) {
    Arriving light = light_at(i, position);
    vec3 lit = light.radiance * light_on_skin(bare, surface, light.to_light);
#ifdef SHADOW_MAPS
    lit *= cast_visibility(int(i), position, hull, normal);
#endif
    sum += lit;
  }
  return sum;
}
