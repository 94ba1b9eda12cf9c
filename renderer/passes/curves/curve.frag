#version 450 core
#include "frame.glsl"
#include "lighting.glsl"
#include "fragment.glsl"

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
  vec3 to_eye = unit_or_zero(frame.eye.xyz - place);
  Fibre fibre = Fibre(place, normal, unit_or_zero(tangent), to_eye, colour, 1.0, 0.0, number);
  put_fragment(vec4(fibre_light(fibre) * opacity, opacity));
}
