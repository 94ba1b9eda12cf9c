#version 450 core
// Resizes light to the picture's size and encodes it with eight bits: renderer/finish, a pixel a lane.
#include "../../shaders/constants.glsl"
#include "../../shaders/dialect.glsl"
layout(local_size_x = 16, local_size_y = 16) in;
layout(std430, binding = 0) readonly buffer Rows {
  uvec4 found;
  vec4 rows[];
};
layout(std430, binding = 1) writeonly buffer Picture { uint picture[]; };

struct Encoding {
  float exposure;
  bool filmic, transparent, studio;
  vec3 background;
  int width, height, largest;
};
uniform Encoding encoding;
uniform ivec2 light_size;
#include "../../shaders/shared/encode.glsl"

vec4 texel(ivec2 at) {
  ivec2 held = clamp(at, ivec2(0), light_size - 1);
  return rows[held.y * light_size.x + held.x];
}

vec4 taps(float t) {  // weights of the cubic of Catmull and Rom 1974
  float u = 1.0 - t;
  return vec4(-0.5 * t * u * u, 1.0 + t * t * (1.5 * t - 2.5), 1.0 + u * u * (1.5 * u - 2.5), -0.5 * u * t * t);
}

// ResizedLight::enlarged of renderer/finish/resize.cpp.
vec4 enlarged(vec2 at) {
  ivec2 start = ivec2(floor(at));
  vec4 v = taps(at.x - floor(at.x)), w = taps(at.y - floor(at.y));
  vec4 a = texel(start), b = texel(start + ivec2(1, 0)), c = texel(start + ivec2(0, 1)), d = texel(start + 1);
  vec4 low = min(min(a, b), min(c, d)), high = max(max(a, b), max(c, d));
  vec4 sum = w[1] * (v[1] * a + v[2] * b) + w[2] * (v[1] * c + v[2] * d);
  sum += w[0] * (v[1] * texel(start + ivec2(0, -1)) + v[2] * texel(start + ivec2(1, -1)));
  sum += w[1] * (v[0] * texel(start + ivec2(-1, 0)) + v[3] * texel(start + ivec2(2, 0)));
  sum += w[2] * (v[0] * texel(start + ivec2(-1, 1)) + v[3] * texel(start + ivec2(2, 1)));
  sum += w[3] * (v[1] * texel(start + ivec2(0, 2)) + v[2] * texel(start + ivec2(1, 2)));
  return clamp(sum / (1.0 - (v[0] + v[3]) * (w[0] + w[3])), low, high);
}

// Returns the mean of the light that a pixel covers.
vec4 mean_of(ivec2 pixel, float scale) {
  vec2 low = vec2(pixel) * scale, high = low + scale;
  ivec2 begin = ivec2(floor(low)), end = ivec2(ceil(high));
  vec4 sum = vec4(0.0);
  float total = 0.0;
  for (int y = begin.y; y < end.y; ++y) {
    for (int x = begin.x; x < end.x; ++x) {
      vec2 share = max(min(high, vec2(x, y) + 1.0) - max(low, vec2(x, y)), 0.0);
      sum += share.x * share.y * texel(ivec2(x, y));
      total += share.x * share.y;
    }
  }
  return sum / total;
}

vec4 light_of(ivec2 pixel) {
  if (light_size == ivec2(encoding.width, encoding.height)) return texel(pixel);
  float scale = float(light_size.y) / float(encoding.height);
  return scale < 1.0 ? enlarged((vec2(pixel) + 0.5) * scale - 0.5) : mean_of(pixel, scale);
}

void main() {
  ivec2 pixel = ivec2(gl_GlobalInvocationID.xy);
  if (pixel.x >= encoding.width || pixel.y >= encoding.height) return;
  vec4 light = light_of(pixel);
  vec4 shown = encoded(float(pixel.x) + 0.5, float(pixel.y) + 0.5, light.rgb, light.a);
  uvec4 number = uvec4(clamp(floor(shown * 255.0 + 0.5), 0.0, 255.0));
  picture[pixel.y * encoding.width + pixel.x] = number.x | number.y << 8 | number.z << 16 | number.w << 24;
}
