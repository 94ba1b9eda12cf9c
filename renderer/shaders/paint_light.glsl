// Paint and water on colours and highlights. Include it after lighting.glsl, whose variables are set here.
#include "constants.glsl"
#include "paint.glsl"

#ifdef PAINT_COLOUR
// Blends paint over the colour of a strand, interpolated between the paint at the roots and at the tips. `lighter` is
// the strand's lightness relative to the strands around it; it is kept, or fur would look like felt.
vec3 colour_painted(vec3 colour, float height, float lighter) {
  vec4 paint = mix(root_paint, tip_paint, height);
  paint_above = mix(paint, tip_paint, 0.5);
  return colour * (1.0 - paint.a) + paint.rgb * lighter;
}
#endif

#ifdef PAINT
// Returns the factor of renderer/coat/strand_tile.h for the water that is painted beyond the coat's own.
float wetter(float rise) {
  float own = paint_block.coat.x, total = min(own + amounts.z, 1.0);
  return (1.0 + rise * total) / (1.0 + rise * own);
}

vec3 colour_wetted(vec3 colour) {
  if (amounts.z <= 0.0) return colour;
  shine = Shine(wetter(water_shines), wetter(water_sharpens));
  return pow(max(colour, 0.0), vec3(wetter(water_darkens)));
}
#endif
