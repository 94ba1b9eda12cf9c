#version 450 core
#undef CURVE_SHADOWS  // on the map a curve cannot be told from its neighbours
#include "frame.glsl"
#include "lighting.glsl"
#include "fragment.glsl"
#ifdef AOVS
#include "aovs.glsl"
#endif
#ifdef COVERING
#include "covering.glsl"
#endif

uniform float min_opacity;

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
  if (opacity < min_opacity) discard;
#ifdef COVERING
#ifdef CROSSING
  keep_crossings();
#endif
  put_fragment(covering(opacity));
#else
  vec3 to_camera = unit_or_zero(frame.viewpoint.xyz - place), along = unit_or_zero(tangent);
  Fibre fibre = Fibre(place, vec4(place, 0.0), normal, along, to_camera, colour, colour_above(1.0), 1.0, 0.0, number);
  put_fragment(vec4(fibre_light(fibre) * opacity, opacity));
#ifdef AOVS
  write_aovs(place, normal, along, colour, 0.0, opacity);
#endif
#endif
}
