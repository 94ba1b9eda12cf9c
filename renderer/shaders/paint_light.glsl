// What paint does to colours and highlights. After lighting.glsl, which has the numbers that are set here.
#include "constants.glsl"
#include "paint.glsl"

#ifdef PAINT_COLOUR
// Paint over the colour of a strand, between the one at the roots and the one at the tips. `lighter` is how much lighter
// the strand is than those around it: paint leaves that, or fur would look like felt.
vec3 colour_painted(vec3 colour, float height, float lighter) {
  vec4 paint = mix(root_paint, tip_paint, height);
  paint_above = mix(paint, tip_paint, 0.5);
  return colour * (1.0 - paint.a) + paint.rgb * lighter;
}
#endif

#ifdef PAINT
// As renderer/coat/strand_tile.h, for the water that is painted beyond the coat's own.
float wetter(float rise) {
  float own = paint_block.coat.x, whole = min(own + amounts.z, 1.0);
  return (1.0 + rise * whole) / (1.0 + rise * own);
}

vec3 colour_wetted(vec3 colour) {
  if (amounts.z <= 0.0) return colour;
  shine = Shine(wetter(water_shines), wetter(water_sharpens));
  return pow(max(colour, 0.0), vec3(wetter(water_darkens)));
}
#endif
