#version 450 core
// Finds the distance of the surface behind the strands in each pixel: the skin, or an eye in front of it. Also finds the
// furthest of these distances in each tile and each block of pixels, behind which no strand is visible.
#include "../../shaders/constants.glsl"
#include "scene.glsl"
layout(local_size_x = 16, local_size_y = 16) in;
layout(std430, binding = 0) readonly buffer SkinPixels { uint skin_pixels[]; };
layout(std430, binding = 1) writeonly buffer Ends { float ends[]; };  // 1 / distance, 0 for none
layout(std430, binding = 2) writeonly buffer Furthest { float furthest[]; };
layout(std430, binding = 3) writeonly buffer Blocks { float blocks[]; };
layout(std430, binding = 4) readonly buffer DrawnTiles { uint drawn_tiles[]; };
layout(std430, binding = 5) readonly buffer EyePixels { uint eye_pixels[]; };

shared uint of_tile, of_block[16];

void main() {
  uint tile = gl_WorkGroupID.y * uint(tiles.x) + gl_WorkGroupID.x;
  uvec2 off = gl_LocalInvocationID.xy;
  uint pixel = tile * tile_pixels + off.y * tile_side + off.x, block = off.y / 4 * 4 + off.x / 4;
  if (gl_LocalInvocationIndex == 0) of_tile = 0xffffffffu;
  if (gl_LocalInvocationIndex < 16) of_block[gl_LocalInvocationIndex] = 0xffffffffu;
  barrier();
  uint end = skin_pixels[2 * pixel];  // floats above 0 sort like their bits
  if (eye_count > 0) end = max(end, eye_pixels[2 * pixel]);
  ends[pixel] = uintBitsToFloat(end);
  atomicMin(of_tile, end);
  atomicMin(of_block[block], end);
  barrier();
  if (gl_LocalInvocationIndex < 16) {
    uvec2 at = 4 * gl_WorkGroupID.xy + uvec2(gl_LocalInvocationIndex % 4, gl_LocalInvocationIndex / 4);
    blocks[at.y * uint(4 * tiles.x) + at.x] = uintBitsToFloat(of_block[gl_LocalInvocationIndex]);
  }
  if (gl_LocalInvocationIndex == 0) furthest[tile] = drawn_tiles[tile] != 0 ? uintBitsToFloat(of_tile) : 3.4e38;
}
