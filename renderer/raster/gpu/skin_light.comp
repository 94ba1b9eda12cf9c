#version 450 core
// Adds the light of the skin, weighted by the transmittance in front of it: renderer/raster/skin_light-inl.h, a pixel a
// lane.
#include "../../shaders/constants.glsl"
#include "../../shaders/frame.glsl"
#include "../../shaders/dialect.glsl"
#include "scene.glsl"
#include "shown.glsl"
layout(local_size_x = 16, local_size_y = 16) in;
layout(std430, binding = sums_storage) buffer Sums { vec4 sums[]; };  // rgb: what is shown; a: transmittance
layout(std430, binding = skin_pixels_storage) readonly buffer SkinPixels { uint skin_pixels[]; };
layout(std430, binding = vertices_storage) readonly buffer Vertices { float vertices[]; };  // position and normal of each
layout(std430, binding = looks_storage) readonly buffer Looks { float looks[]; };           // SkinLook of each corner of each triangle

#ifdef SHOWN_FIELD
#include "field.glsl"
#else
layout(std430, binding = triangles_storage) readonly buffer Triangles { uint triangles[]; };
#include "../../shaders/shared/strand.glsl"
#include "lights.glsl"
#include "../../shaders/bare_skin_block.glsl"
#include "../../shaders/shared/skin_light.glsl"
#include "model_colour.glsl"

float mixed_look(TriangleCorners at, uint number) {
  uint first = 18 * at.triangle + number;
  return looks[first] + at.b * (looks[first + 6] - looks[first]) + at.c * (looks[first + 12] - looks[first]);
}
#endif

vec3 vertex_at(uint vertex, uint number) {
  return vec3(vertices[6 * vertex + number], vertices[6 * vertex + number + 1], vertices[6 * vertex + number + 2]);
}

#ifndef SHOWN_FIELD
vec3 normal_of(uint triangle, uint k) {
  uint at = 3 * corner_words * triangle + k * corner_words + 11;
  vec3 other = vec3(corner_float(at), corner_float(at + 1), corner_float(at + 2));
  return dot(other, other) > 0.0 ? other : vertex_at(triangles[3 * triangle + k], 3);
}

SkinPoint skin_point(TriangleCorners at, vec3 position, vec3 ray, float distance, vec3 across) {
  float size = length(ray);
  vec3 first = normal_of(at.triangle, 0);
  SkinPoint skin;
  skin.position = position;
  skin.to_camera = ray * (-1.0 / size);
  skin.pixel = frame.viewpoint.w * oversampling * distance * size;
  skin.normal = unit(first + at.b * (normal_of(at.triangle, 1) - first) + at.c * (normal_of(at.triangle, 2) - first));
  if (dot(across, ray) > 0.0) skin.normal = -skin.normal;
  skin.colour = model_colour(at, skin.pixel, length(across));
  skin.under = vec3(mixed_look(at, 0), mixed_look(at, 1), mixed_look(at, 2));
  skin.grown = mixed_look(at, 3);
  skin.bare = mixed_look(at, 4);
  skin.wetness = mixed_look(at, 5);
  return skin;
}

vec3 light_of(SkinPoint skin) {
  SkinLooks looks = skin_looks(skin);
#if defined SHOWN_ALBEDO
  return skin_albedo(looks);
#elif defined SHOWN_DIRECT
  return skin_light(skin, looks, false).direct;
#elif defined SHOWN_SHADOW
  SentLight sent = skin_light(skin, looks, true);
  return vec3(luminance(sent.direct), luminance(sent.unshadowed), 0.0);
#else
  SentLight sent = skin_light(skin, looks, false);
  return sent.ambient + sent.direct;
#endif
}
#endif

vec3 output_value(uint triangle, vec2 pixel, float inverse) {
#if defined SHOWN_DISTANCE
  return vec3(1.0 / max(inverse, 1e-12), 0.0, 0.0);
#elif defined SHOWN_DEPTH
  return vec3(inverse, 0.0, 0.0);
#elif defined SHOWN_TRIANGLE
  return vec3(float(triangle), 0.0, 0.0);
#elif defined SHOWN_TANGENT || defined SHOWN_COUNT || defined SHOWN_STRAND
  return vec3(0.0);
#else
  vec3 corner[3];
  for (uint k = 0; k < 3; ++k) corner[k] = vertex_at(triangles[3 * triangle + k], 0);
  vec3 ray = ray_through(pixel);
  float distance = 1.0 / max(inverse, 1e-20);
  vec3 position = camera_position + ray * distance, side = corner[1] - corner[0], other = corner[2] - corner[0];
  vec3 across = cross(side, other);
  float square = max(dot(across, across), 1e-30);
  TriangleCorners at;
  at.triangle = triangle;
  at.b = clamp(dot(cross(position - corner[0], other), across) / square, 0.0, 1.0);
  at.c = clamp(dot(cross(side, position - corner[0]), across) / square, 0.0, 1.0 - at.b);
#if defined SHOWN_FIELD
  return field_at(triangle, at.b, at.c);
#elif defined SHOWN_NORMAL
  return skin_point(at, position, ray, distance, across).normal;
#else
  return light_of(skin_point(at, position, ray, distance, across));
#endif
#endif
}

void main() {
  uint tile = gl_WorkGroupID.y * uint(tiles.x) + gl_WorkGroupID.x, at = tile * tile_pixels + gl_LocalInvocationIndex;
  vec4 sum = sums[at];
  float inverse = uintBitsToFloat(skin_pixels[2 * at]), through = sum.a;
  if (!(inverse > 0.0 && through > min_visible)) return;
  vec2 pixel = vec2(box.xy) + vec2(gl_WorkGroupID.xy * tile_side) + vec2(gl_LocalInvocationID.xy) + 0.5;
#ifdef SHOWN_DEPTH
  through = through >= 0.5 ? 1.0 : 0.0;
#endif
  sums[at] = vec4(sum.rgb + through * output_value(skin_pixels[2 * at + 1], pixel, inverse), 0.0);
}
