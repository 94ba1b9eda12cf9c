#version 450 core
// A change as colour, sRGB with straight alpha; grey where there is none.
in float share;

uniform float strength;  // alpha

layout(location = 0) out vec4 result;

#include "colour_maps.glsl"

void main() { result = vec4(share > 0.0 ? ramp_of(share) : vec3(0.5), strength); }
