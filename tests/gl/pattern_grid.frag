#version 450 core
#include "pattern.glsl"

uniform int what;  // 0 colour, 1 length and lean

layout(location = 0) out vec4 result;

// Directions over the sphere by longitude and latitude; the CPU makes the same ones.
void main() {
  vec2 at = gl_FragCoord.xy / 64.0;
  float turn = 6.2831853 * at.x, up = 1.96 * at.y - 0.98, across = sqrt(1.0 - up * up);
  vec3 normal = vec3(across * cos(turn), up, across * sin(turn));
  vec3 place = vec3(0.2, 0.35, 0.45) * normal;
  result = what == 0 ? vec4(pattern_colour(place, normal, vec3(0.5, 0.4, 0.3)), 1.0)
                     : vec4(pattern_length(place), pattern_lean(place), 0.0, 1.0);
}
