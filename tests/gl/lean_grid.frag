#version 450 core
#include "lean.glsl"

uniform int root_curve;
uniform float root_share;

layout(location = 0) out vec4 result;

void main() {  // x: position along the strand, y: inclination, both over the 33 pixels of a side
  vec2 at = (gl_FragCoord.xy - 0.5) / 32.0;
  result = vec4(lean_point(root_curve == 1, at.y, root_share, at.x), 1.0);
}
