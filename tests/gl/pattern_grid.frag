#version 450 core
#include "pattern.glsl"

layout(location = 0) out vec4 result;

// Mixes weights into a colour, over a grid of weights and colours.
void main() {
  vec2 at = floor(gl_FragCoord.xy) / 32.0;
  vec3 weights = vec3(at.x, fract(3.0 * at.x + 0.3), fract(5.0 * at.x + at.y));
  result = vec4(with_weights(weights, vec3(at.y, 0.5 * at.y, 0.2)), 1.0);
}
