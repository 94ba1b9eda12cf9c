#version 450 core
// Finds the nearest eye in each pixel, if it is no further away than the skin.
#include "../../shaders/constants.glsl"
#include "../../shaders/frame.glsl"
#include "../../shaders/dialect.glsl"
#include "scene.glsl"
#include "eye_shading.glsl"
layout(local_size_x = 16, local_size_y = 16) in;
layout(std430, binding = 0) readonly buffer SkinPixels { uint skin_pixels[]; };

void main() {
  uint at = (gl_WorkGroupID.y * uint(tiles.x) + gl_WorkGroupID.x) * tile_pixels + gl_LocalInvocationIndex;
  ivec2 tile_corner = box.xy + ivec2(gl_WorkGroupID.xy * tile_side);
  vec2 pixel = vec2(tile_corner) + vec2(gl_LocalInvocationID.xy) + 0.5;
  float nearest = uintBitsToFloat(skin_pixels[2 * at]);
  uvec2 found = uvec2(0);
  for (uint k = 0; k < uint(eye_count); ++k) {
    ivec4 around = eye_boxes[k];
    if (any(greaterThanEqual(around.xy, tile_corner + int(tile_side))) || any(lessThanEqual(around.zw, tile_corner))) continue;
    take_eye(k, 0);
    EyeHit hit = hit_of_pixel(pixel);
    float distance = eye.right.w * dot(hit.nearest - eye_viewer, in_eye_frame(camera_forward));
    float inverse = 1.0 / max(distance, 1e-12);
    if (!(hit.there && distance > near_distance && inverse >= nearest)) continue;
    nearest = inverse;
    found = uvec2(floatBitsToUint(inverse), k);
  }
  eye_pixels[2 * at] = found.x;
  eye_pixels[2 * at + 1] = found.y;
}
