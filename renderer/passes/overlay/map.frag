#version 450 core
#include "constants.glsl"
// A map that a light sees, as grey, sRGB with straight alpha.
layout(binding = source_unit) uniform sampler2D map;

uniform vec3 square;  // its left and top edge and its side, pixels
uniform float black;
uniform float white;

layout(location = 0) out vec4 result;

void main() {
  vec2 at = (gl_FragCoord.xy - square.xy) / square.z;
  bool beside = any(lessThan(at, vec2(0.0))) || any(greaterThan(at, vec2(1.0)));
  float grey = clamp((texture(map, at).r - black) / (white - black), 0.0, 1.0);
  result = vec4(vec3(beside ? 0.0 : grey), 1.0);
}
