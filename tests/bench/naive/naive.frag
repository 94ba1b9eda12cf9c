#version 450 core
#include "frame.glsl"
#include "lighting.glsl"
#include "base_colour.glsl"

layout(binding = 0) uniform sampler2DArray shapes;
layout(binding = 1) uniform sampler2DArray colours;

in vec3 place, fibre_normal, fibre_tangent, tile_u, base_uv, base_colour;
in vec2 tile;
in float height;

layout(location = 0) out vec4 result;

// What a text book does: both textures with the hardware's mip levels, and light on every fragment.
void main() {
  vec3 uv = vec3(tile, floor(height * float(slice_count)));
  vec4 shape = texture(shapes, uv);
  vec3 strand = texture(colours, uv).rgb;
  vec3 to_eye = normalize(frame.eye.xyz - place);
  vec3 normal = normalize(fibre_normal);
  float slant = 1.0 / clamp(abs(dot(normal, to_eye)), 0.1, 1.0);
  vec4 scales = frame.depth_scale[int(clamp(textureQueryLod(shapes, tile).x + 0.5, 0.0, 7.0))];
  float scale = mix(scales.x, scales.y, 1.1547005 * sqrt(1.0 - 1.0 / (slant * slant)));
  float opacity = 1.0 - exp2(-stored_depth * 1.442695 * shape.a * scale * slant * float(slice_count) / frame.counts.x);
  vec2 slope = (shape.xy * 2.0 - 1.0) * (stored_slope / nominal_length);
  vec3 tangent = normalize(fibre_tangent + tile_u * slope.x + cross(normal, tile_u) * slope.y);
  Fibre fibre = Fibre(place, normal, tangent, to_eye, fur_colour(strand * strand, base_colour, base_uv), height,
                      -stored_light * log(max(shape.b, 0.004)), 0.5);
  result = vec4(fibre_light(fibre) * opacity, opacity);
}
