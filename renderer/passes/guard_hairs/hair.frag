#version 450 core
#include "frame.glsl"
#include "lighting.glsl"
#include "base_colour.glsl"
#ifdef PATTERN
#include "pattern.glsl"
#endif
#include "paint_light.glsl"
#include "fragment.glsl"
#ifdef AOVS
#include "aovs.glsl"
#endif
#ifdef COVERING
#include "covering.glsl"
#endif

layout(binding = colours_unit) uniform sampler2DArray colours;  // as slab.glsl

uniform float min_opacity;

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
in vec2 tile;
in float across;
flat in float lightness;
in float reach;
in float strength;

const float local_mean = 5.0;  // level whose texels hold a few strands' colours

// The colour of a hair of this colour in the coat, by `lighter` lighter than others.
vec3 hair_colour(vec3 strand_colour, float lighter) {
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

vec3 hair_normal() { return fibre_normal / max(length(fibre_normal), 1e-20); }
vec3 hair_tangent() { return fibre_tangent / max(length(fibre_tangent), 1e-20); }

// What a hair of that colour and number sends to the camera.
vec3 hair_light(vec3 colour, float number) {
  int above = clamp(int(height * float(slice_count)), 0, slice_count - 1);
  float strands = frame.depth_above[above / 4][above % 4] * length_share;
#ifdef PAINT
  strands *= painted_depth();
#endif
  vec3 to_camera = frame.viewpoint.xyz - place;
  to_camera /= max(length(to_camera), 1e-20);
  return fibre_light(Fibre(place, vec4(place, 0.0), hair_normal(), hair_tangent(), to_camera, colour, colour_above(height),
                           clamp(height, 0.0, 1.0), strands, number));
}

void main() {
  float opacity = strength * clamp(reach + 0.5 - abs(across), 0.0, 1.0);
  if (opacity < min_opacity) discard;
#ifdef COVERING
#ifdef CROSSING
  keep_crossings();
#endif
  put_fragment(covering(opacity));
#else
  int slice = clamp(int(height * float(slice_count)), 0, slice_count - 1);
  vec3 strand = textureLod(colours, vec3(tile, float(slice)), local_mean).rgb;
  vec3 colour = hair_colour(strand * strand * lightness, lightness);
  put_fragment(vec4(hair_light(colour, 0.5) * opacity, opacity));
#ifdef AOVS
  write_aovs(place, hair_normal(), hair_tangent(), colour, 0.0, opacity);
#endif
#endif
}
