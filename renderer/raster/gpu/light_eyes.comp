#version 450 core
// Adds the light of eyes, weighted by the transmittance of the strands in front. At an eye's edge part of the pixel is
// left to the skin.
#include "../../shaders/constants.glsl"
#include "../../shaders/frame.glsl"
#include "../../shaders/dialect.glsl"
#include "scene.glsl"
#include "shown.glsl"
#include "eye_shading.glsl"
layout(local_size_x = 16, local_size_y = 16) in;
layout(std430, binding = sums_storage) buffer Sums { vec4 sums[]; };  // rgb: what is shown; a: transmittance

// Returns the part of an eye's light that comes from the scene's lights.
vec3 direct_light(EyeHit hit) {
  vec3 total = eye_light(hit);
  eye_lights = 0;
  return max(total - eye_light(hit), 0.0);
}

// Returns what the picture shows of an eye. Lids and cornea count as reflection, not as shadow.
vec3 output_value(EyeHit hit, float inverse) {
#if defined SHOWN_ALBEDO
  return eye_surface(hit).albedo;
#elif defined SHOWN_NORMAL
  return eye_surface(hit).normal;
#elif defined SHOWN_FIELD || defined SHOWN_TANGENT || defined SHOWN_COUNT || defined SHOWN_STRAND
  return vec3(0.0);
#elif defined SHOWN_DIRECT
  return direct_light(hit);
#elif defined SHOWN_SHADOW
  return vec3(vec2(luminance(direct_light(hit))), 0.0);
#elif defined SHOWN_DISTANCE
  return vec3(1.0 / max(inverse, 1e-12), 0.0, 0.0);
#elif defined SHOWN_DEPTH
  return vec3(inverse, 0.0, 0.0);
#else
  return eye_light(hit);
#endif
}

void main() {
  uint at = (gl_WorkGroupID.y * uint(tiles.x) + gl_WorkGroupID.x) * tile_pixels + gl_LocalInvocationIndex;
  uint inverse = eye_pixels[2 * at];
  if (inverse == 0) return;
  vec4 sum = sums[at];
  if (!(sum.a > min_visible)) return;
  vec2 pixel = vec2(box.xy) + vec2(gl_WorkGroupID.xy * tile_side) + vec2(gl_LocalInvocationID.xy) + 0.5;
  take_eye(eye_pixels[2 * at + 1], int(light_count));
  EyeHit hit = hit_of_pixel(pixel);
  if (!hit.there) return;
  float weight = sum.a * hit.covered, left_over = sum.a - weight;
#ifdef SHOWN_DEPTH
  weight = sum.a >= 0.5 && left_over < 0.5 ? 1.0 : 0.0;
#endif
  sums[at] = vec4(sum.rgb + weight * output_value(hit, uintBitsToFloat(inverse)), left_over);
}
