#version 450 core
// The count of shells as colour, sRGB with straight alpha.
#include "gather.glsl"
#include "colour_maps.glsl"

uniform float max_count;      // shells
uniform float strength;  // alpha

layout(location = 0) out vec4 result;

void main() {
  float count = gather(ivec2(gl_FragCoord.xy)).r;
  result = vec4(ramp_of(count / max_count), count > 0.0 ? strength : 0.0);
}
