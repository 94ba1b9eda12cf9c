#version 450 core
// The shadow-width map: the inverted occlusion map reduced to a quarter. Sampling it linearly enlarges it again, and the
// grey near an edge stands for the distance to it (GPU fur 4).
layout(binding = 6) uniform sampler2D occlusion;

layout(location = 0) out float width;

void main() {
  ivec2 first = 4 * ivec2(gl_FragCoord.xy), last = textureSize(occlusion, 0) - 1;
  float sum = 0.0;
  for (int y = -2; y < 6; ++y) {
    for (int x = -2; x < 6; ++x) sum += texelFetch(occlusion, clamp(first + ivec2(x, y), ivec2(0), last), 0).r;
  }
  width = sum / 64.0;
}
