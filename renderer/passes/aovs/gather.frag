#version 450 core
// An AOV at the picture's size.
#include "gather.glsl"

uniform int rule;  // GatherRule of aovs_pass.cpp

layout(location = 0) out vec4 result;

void main() {
  ivec2 pixel = ivec2(gl_FragCoord.xy);
  vec4 sum = gather(pixel);
  float alpha = clamp(sum.a, 0.0, 1.0);
  result = sum;
  if (rule == 1) result = vec4(alpha > 0.0 ? sum.rgb / sum.a : vec3(0.0), alpha);
  if (rule == 2) result = vec4(dot(sum.rgb, sum.rgb) > 1e-12 ? normalize(sum.rgb) : vec3(0.0), alpha);
  if (rule == 3) result = vec4(vec3(sum.g > 0.0 ? clamp(sum.r / sum.g, 0.0, 1.0) : 1.0), alpha);
  if (rule == 4) result = texelFetch(drawn, min(ivec2((vec2(pixel) + 0.5) * scale), textureSize(drawn, 0) - 1), 0);
}
