#version 450 core
#undef CURVE_SHADOWS  // on the map a curve cannot be told from its neighbours
#include "frame.glsl"
#include "lighting.glsl"
#include "fragment.glsl"
#ifdef LAYERS
#include "layers.glsl"
#endif
#ifdef COVERING
#include "covering.glsl"
#endif

uniform float least_opacity;

in vec3 place;
in vec3 tangent;
in vec3 colour;
flat in vec3 normal;
flat in float number;
in float across;
in float reach;
in float strength;

// A curve is lit as a strand at the tips of the fur that it grows from: nothing stands above it.
void main() {
  float opacity = strength * clamp(reach + 0.5 - abs(across), 0.0, 1.0);
  if (opacity < least_opacity) discard;
#ifdef COVERING
#ifdef CROSSING
  keep_crossings();
#endif
  put_fragment(covering(opacity));
#else
  vec3 to_eye = unit_or_zero(frame.eye.xyz - place), along = unit_or_zero(tangent);
  Fibre fibre = Fibre(place, vec4(place, 0.0), normal, along, to_eye, colour, colour_above(1.0), 1.0, 0.0, number);
  put_fragment(vec4(fibre_light(fibre) * opacity, opacity));
#ifdef LAYERS
  write_layers(place, normal, along, colour, 0.0, opacity);
#endif
#endif
}
