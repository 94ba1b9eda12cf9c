#version 450 core
// Finds for each block of pixels 1 / the furthest distance in the blocks around it; 0 if those reach out of the box
// (SkinPixels::hidden).
#include "../../shaders/constants.glsl"
#include "scene.glsl"
layout(local_size_x = 16, local_size_y = 16) in;
layout(std430, binding = 0) readonly buffer Blocks { float blocks[]; };
layout(std430, binding = 1) writeonly buffer Hidden { float hidden[]; };

void main() {
  const int around = 2;  // blocks
  ivec2 at = ivec2(gl_GlobalInvocationID.xy), size = 4 * tiles;
  if (any(greaterThanEqual(at, size))) return;
  float furthest = 3.4e38;
  for (int y = -around; y <= around; ++y) {
    for (int x = -around; x <= around; ++x) {
      ivec2 other = at + ivec2(x, y);
      bool inside = all(greaterThanEqual(other, ivec2(0))) && all(lessThan(other, size));
      furthest = min(furthest, inside ? blocks[other.y * size.x + other.x] : 0.0);
    }
  }
  hidden[at.y * size.x + at.x] = furthest;
}
