#version 450 core
#include "frame.glsl"
#include "lighting.glsl"
#include "base_colour.glsl"

layout(binding = 0) uniform sampler2DArray shapes;
layout(binding = 1) uniform sampler2DArray colours;

uniform int shell_count;
uniform int shell;

in vec3 world_position, fibre_normal, fibre_tangent, tile_u, base_uv, base_colour;
in vec2 tile;
in float level, slant, density_share, length_share;

layout(location = 0) out vec4 result;

// The textbook way to draw the same fur: one sample per shell, trilinear lookups in both textures, light on every
// fragment.
void main() {
  float height = (float(shell) + 0.5) / float(shell_count);
  vec3 uv = vec3(tile, floor(height * float(slice_count)));
  vec4 shape = textureLod(shapes, uv, level), texel = textureLod(colours, uv, level);
  vec3 normal = normalize(fibre_normal);
  vec4 scales = frame.depth_scale[int(level + 0.5)];
  float steep = max(slant, 1.0), slanted = clamp(1.1547005 * sqrt(1.0 - 1.0 / (steep * steep)), 0.0, 1.0);
  float scale = mix(scales.x, scales.y, slanted) * min(steep, 10.0);
  float opacity = 1.0 - exp2(-stored_depth * 1.442695 * shape.a * density_share * scale * float(slice_count) / float(shell_count));
  vec2 slope = (shape.xy * 2.0 - 1.0) * (stored_slope / nominal_length);
  vec3 tangent = normalize(fibre_tangent + tile_u * slope.x + cross(normal, tile_u) * slope.y);
  vec3 colour = fur_colour(texel.rgb * texel.rgb, base_colour, base_uv);
  Fibre fibre = Fibre(world_position, normal, tangent, normalize(frame.viewpoint.xyz - world_position), colour,
                      colour * colour_above(height), height, -stored_light * log(max(shape.b, 0.004)) * length_share, texel.a, shine);
  result = vec4(fibre_light(fibre, vec4(world_position, 0.0)) * opacity, opacity);
}
