#version 450 core
#include "frame.glsl"
#include "lighting.glsl"
#include "base_colour.glsl"

layout(binding = 0) uniform sampler2DArray shapes;   // slope, light from above, optical depth
layout(binding = 1) uniform sampler2DArray colours;  // strand colour (square root), number

uniform int shell_step;  // 1: seen from outside, the slab's top comes first

in vec3 place;
in vec3 fibre_normal;
in vec3 fibre_tangent;
in vec2 tile;
in vec2 tile_per_height;
in float level;
in float slant;
flat in vec3 tile_u;
in vec3 base_uv;
in vec3 base_colour;
flat in int shell;

layout(location = 0) out vec4 result;  // premultiplied

// What the ray meets inside the slab, front to back.
struct Slab {
  float opacity, height, light;
  vec2 slope;
};

Slab march() {
  int steps = int(frame.counts.y);
  float thickness = 1.0 / frame.counts.x;
  float sharp = floor(level + 0.5);
  vec4 scales = frame.depth_scale[int(sharp)];
  float slanted = clamp(2.0 - 2.0 / slant, 0.0, 1.0);  // 0 along the stack, 1 from 60 degrees on
  float scale = stored_depth * 1.442695 * mix(scales.x, scales.y, slanted) * min(slant, 10.0) *
                float(slice_count) * thickness / float(steps);
  Slab slab = Slab(0.0, 0.0, 0.0, vec2(0.0));
  for (int i = 0; i < steps; ++i) {
    float off = (0.5 - (float(i) + 0.5) / float(steps)) * thickness * float(shell_step);
    float s = (float(shell) + 0.5) * thickness + off;
    vec3 uv = vec3(tile + tile_per_height * off, floor(s * float(slice_count)));
    vec4 shape = textureLod(shapes, uv, sharp);
    float weight = (1.0 - slab.opacity) * (1.0 - exp2(-scale * shape.a));
    slab.opacity += weight;
    slab.height += weight * s;
    slab.light += weight * shape.b;
    slab.slope += weight * shape.xy;
    if (slab.opacity > 0.985) break;
  }
  return slab;
}

void main() {
  Slab slab = march();
  if (slab.opacity < 0.004) discard;
  float share = 1.0 / slab.opacity;
  float height = slab.height * share;
  float off = height - (float(shell) + 0.5) / frame.counts.x;
  vec3 uv = vec3(tile + tile_per_height * off, floor(height * float(slice_count)));
  vec3 strand = textureLod(colours, uv, floor(level + 0.5)).rgb;
  strand *= strand;
  vec2 slope = (slab.slope * share * 2.0 - 1.0) * (stored_slope / nominal_length);
  vec3 normal = normalize(fibre_normal);
  vec3 tangent = normalize(fibre_tangent + tile_u * slope.x + cross(normal, tile_u) * slope.y);
  float above = -log(max(slab.light * share, 0.004));
  Fibre fibre = Fibre(place, normal, tangent, normalize(frame.eye.xyz - place),
                      fur_colour(strand, base_colour, base_uv), height, above);
  result = vec4(fibre_light(fibre) * slab.opacity, slab.opacity);
}
