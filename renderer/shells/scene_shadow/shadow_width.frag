#version 450 core
#include "constants.glsl"
// The shadow-width map (GPU fur 4): the inverted occlusion map, reduced. Linear sampling enlarges it again; intermediate
// values near an edge then stand for the distance to the edge.
layout(binding = width_maps_unit) uniform sampler2D occlusion;

uniform int ratio;  // texels of the occlusion map along a side of a texel of this map

layout(location = 0) out vec2 width;

void main() {
  ivec2 last = textureSize(occlusion, 0) - 1, first = ratio * ivec2(gl_FragCoord.xy);
  vec2 sum = vec2(0.0);
  int half_step = ratio / 2;
  for (int y = -half_step; y < ratio + half_step; ++y) {
    for (int x = -half_step; x < ratio + half_step; ++x) sum += texelFetch(occlusion, clamp(first + ivec2(x, y), ivec2(0), last), 0).rg;
  }
  width = sum / float((ratio + 2 * half_step) * (ratio + 2 * half_step));
}
