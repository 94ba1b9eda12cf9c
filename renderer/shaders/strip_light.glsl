// The light on a strip: what fins and guard hairs share. After frame.glsl, lighting.glsl and base_colour.glsl.
in vec3 place;
in vec3 fibre_normal;
in vec3 fibre_tangent;
in vec3 base_uv;
in vec3 base_colour;
in float height;   // s
#ifdef PATTERN
in vec3 root;
in vec4 varied;
#endif

// The colour of a strip of fur of this colour in the coat.
vec3 strip_colour(vec3 strand_colour) {
  vec3 colour = fur_colour(strand_colour, base_colour, base_uv);
#ifdef PATTERN
  colour = pattern_colour(root, varied, colour);
#endif
  return colour;
}

vec3 strip_normal() { return fibre_normal / max(length(fibre_normal), 1e-20); }
vec3 strip_tangent() { return fibre_tangent / max(length(fibre_tangent), 1e-20); }

// What a strip of that colour and number sends to the eye.
vec3 strip_light(vec3 colour, float number) {
  int above = clamp(int(height * float(slice_count)), 0, slice_count - 1);
  float depth = frame.depth_above[above / 4][above % 4];
  vec3 to_eye = frame.eye.xyz - place;
  to_eye /= max(length(to_eye), 1e-20);
  return fibre_light(Fibre(place, strip_normal(), strip_tangent(), to_eye, colour, clamp(height, 0.0, 1.0), depth, number));
}
