#version 450 core
// A field as colour, sRGB with straight alpha; or for strokes the direction itself.
in vec2 lean;
in float fur_length;
in vec3 painted;  // density, wetness, mask

uniform int kind;        // FieldKind of overlay_pass.cpp
uniform float longest;   // fur, sizes
uniform bool touched;    // whether the model has painted fields at all
uniform float strength;  // alpha

layout(location = 0) out vec4 result;

#include "colour_maps.glsl"

void main() {
  if (kind == 0) result = vec4(hue_of(lean), strength);
  if (kind == 1) result = vec4(lean, fur_length > 0.0 ? 1.0 : 0.0, 1.0);
  if (kind == 2) result = vec4(ramp_of(fur_length / max(longest, 1e-9)), strength);
  if (kind > 2) result = vec4(ramp_of((touched ? painted : vec3(1.0, 0.0, 1.0))[kind - 3]), strength);
}
