// The light on a strip: what fins and guard hairs share. After frame.glsl, lighting.glsl and base_colour.glsl.
#include "paint_light.glsl"

in vec3 place;
in vec3 fibre_normal;
in vec3 fibre_tangent;
in vec3 base_uv;
in vec3 base_colour;
in float height;   // s
in float length_share;  // of the fur, over nominal_length
#ifdef PATTERN
in vec3 root;
in vec4 varied;
#endif

// The colour of a strip of fur of this colour in the coat, by `lighter` lighter than others.
vec3 strip_colour(vec3 strand_colour, float lighter) {
  vec3 colour = fur_colour(strand_colour, base_colour, base_uv);
#ifdef PATTERN
  colour = pattern_colour(root, varied, colour);
#endif
#ifdef PAINT_COLOUR
  colour = colour_painted(colour, clamp(height, 0.0, 1.0), lighter);
#endif
#ifdef PAINT
  colour = colour_wetted(colour);
#endif
  return colour;
}

vec3 strip_normal() { return fibre_normal / max(length(fibre_normal), 1e-20); }
vec3 strip_tangent() { return fibre_tangent / max(length(fibre_tangent), 1e-20); }

// What a strip of that colour and number sends to the camera.
vec3 strip_light(vec3 colour, float number) {
  int above = clamp(int(height * float(slice_count)), 0, slice_count - 1);
  float strands = frame.depth_above[above / 4][above % 4] * length_share;
#ifdef PAINT
  strands *= painted_depth();
#endif
  vec3 to_camera = frame.viewpoint.xyz - place;
  to_camera /= max(length(to_camera), 1e-20);
  return fibre_light(Fibre(place, vec4(place, 0.0), strip_normal(), strip_tangent(), to_camera, colour, colour_above(height),
                           clamp(height, 0.0, 1.0), strands, number));
}
