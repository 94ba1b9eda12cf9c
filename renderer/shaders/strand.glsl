// A strand that grows from the model, read from the buffers of renderer/upload/model_buffers.h: the same places as those
// that shells interpolate. After frame.glsl and lean.glsl.
#include "constants.glsl"
#include "unit.glsl"

layout(std430, binding = vertex_storage) readonly buffer VertexBuffer { float values[]; } vertex_buffer;
layout(std430, binding = groom_storage) readonly buffer GroomBuffer { float values[]; } groom_buffer;
#ifdef PATTERN
layout(std430, binding = variation_storage) readonly buffer VariationBuffer { vec4 values[]; } variation_buffer;
#endif


vec2 vertex_vec2(uint vertex, int at) {
  int i = int(vertex) * vertex_floats + at;
  return vec2(vertex_buffer.values[i], vertex_buffer.values[i + 1]);
}
vec3 vertex_vec3(uint vertex, int at) {
  return vec3(vertex_vec2(vertex, at), vertex_buffer.values[int(vertex) * vertex_floats + at + 2]);
}

struct Strand {
  vec3 root, place, normal, tangent;  // of the fibre; not unit
  vec2 tile_uv;                       // of the root, sizes
  vec3 image_uv, colour;
  float fur_length;
  vec4 varied;                        // as pattern.glsl has it
};

// The strand of a vertex at height s; `stretch` is a factor on its length.
Strand strand_at(uint vertex, float s, float stretch) {
  vec3 normal = vertex_vec3(vertex, 3), tangent = vertex_vec3(vertex, 6);
  int at = 3 * int(vertex);
  vec2 direction = vec2(groom_buffer.values[at], groom_buffer.values[at + 1]);
  float fur_length = groom_buffer.values[at + 2], inclination = min(length(direction), 1.0);
  vec4 varied = vec4(1.0, 0.0, 1.0, 0.0);
#ifdef PATTERN
  varied = variation_buffer.values[vertex];
  fur_length *= varied.x;
  inclination = clamp(inclination + varied.y, 0.0, 1.0);
#endif
  vec3 lean = lean_along(direction, normal, tangent);
  vec3 curve = lean_point(frame.tile.z > 0.5, inclination, frame.counts.w, s);
  vec3 root = vertex_vec3(vertex, 0);
  return Strand(root, root + fur_length * stretch * (curve.x * lean + curve.y * normal), normal,
                lean * sin(curve.z) + normal * cos(curve.z), vertex_vec2(vertex, 9), vertex_vec3(vertex, 14),
                vertex_vec3(vertex, 17), fur_length, varied);
}

// As skin.frag: no fur below a length.
float furred(float fur_length) { return smoothstep(0.0, 0.008, fur_length); }
