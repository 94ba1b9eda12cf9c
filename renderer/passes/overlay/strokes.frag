#version 450 core
#include "constants.glsl"
// Short lines along the fur: one in each cell of the picture, thick at the root, thin at the tip; the longer the more the
// fur leans, and a dot where it stands upright or points at the eye.
layout(binding = source_unit) uniform sampler2D field;  // lean (right, up), whether there is fur, whether there is skin

layout(location = 0) out vec4 result;

const float cell = 10.0;                            // pixels
const float longest = 1.6;                          // cells
const float root_width = 0.8, tip_width = 0.2;      // half widths, pixels
const float silhouette = 0.9;                          // pixels

// Cells are moved a little, so that rows do not catch the eye.
vec2 moved(ivec2 at) { return 0.3 * (fract(sin(vec2(at.x * 127 + at.y * 311, at.x * 269 + at.y * 183) * 0.37) * 43.758) - 0.5); }

// Distance of a pixel's middle to a stroke's edge.
float distance_to(ivec2 at, vec2 pixel) {
  vec2 root = (vec2(at) + 0.5 + moved(at)) * cell;
  ivec2 size = textureSize(field, 0);
  if (any(lessThan(root, vec2(0.0))) || any(greaterThanEqual(root, vec2(size)))) return 1e3;
  vec4 fur = texelFetch(field, ivec2(root), 0);
  if (fur.z < 0.5) return 1e3;
  vec2 along = vec2(fur.x, -fur.y) * inversesqrt(max(length(fur.xy), 1e-4)) * cell * longest, apart = pixel - root;
  float share = clamp(dot(apart, along) / max(dot(along, along), 1e-6), 0.0, 1.0);
  return length(apart - share * along) - mix(root_width, tip_width, share);
}

void main() {
  ivec2 middle = ivec2(floor(gl_FragCoord.xy / cell));
  float nearest = 1e3;
  for (int y = -2; y <= 2; ++y) {
    for (int x = -2; x <= 2; ++x) nearest = min(nearest, distance_to(middle + ivec2(x, y), gl_FragCoord.xy));
  }
  float core = clamp(0.5 - nearest, 0.0, 1.0), whole = clamp(0.5 + silhouette - nearest, 0.0, 1.0);
  result = vec4(vec3(core), max(core, 0.6 * whole));
}
