#include "constants.glsl"
layout(binding = source_unit) uniform sampler2D drawn;

uniform float scale;  // drawn size over picture size

// Weights of the pixels at -1, 0, 1 and 2 for a place `t` beyond 0: the cubic of Catmull and Rom 1974.
vec4 catmull_rom(float t) {
  float u = 1.0 - t;
  return vec4(-0.5 * t * u * u, 1.0 + t * t * (1.5 * t - 2.5), 1.0 + u * u * (1.5 * u - 2.5), -0.5 * u * t * t);
}

// Where it was drawn smaller: Catmull-Rom without the four corners, whose weights are at most 1/256, held between the four
// nearest drawn pixels, so that it does not ring.
vec4 enlarge(ivec2 pixel) {
  vec2 at = (vec2(pixel) + 0.5) * scale - 0.5;
  vec2 start = floor(at);
  ivec2 last = textureSize(drawn, 0) - 1, base = ivec2(start);
  ivec2 p0 = clamp(base - 1, ivec2(0), last), p1 = clamp(base, ivec2(0), last), p2 = clamp(base + 1, ivec2(0), last),
        p3 = clamp(base + 2, ivec2(0), last);
  vec4 a = texelFetch(drawn, p1, 0), b = texelFetch(drawn, ivec2(p2.x, p1.y), 0);
  vec4 c = texelFetch(drawn, ivec2(p1.x, p2.y), 0), d = texelFetch(drawn, p2, 0);
  vec4 low = min(min(a, b), min(c, d)), high = max(max(a, b), max(c, d));
  if (low == high) return low;
  vec4 x = catmull_rom(at.x - start.x), y = catmull_rom(at.y - start.y);
  vec4 sum = y.y * (x.y * a + x.z * b) + y.z * (x.y * c + x.z * d);
  sum += y.x * (x.y * texelFetch(drawn, ivec2(p1.x, p0.y), 0) + x.z * texelFetch(drawn, ivec2(p2.x, p0.y), 0));
  sum += y.y * (x.x * texelFetch(drawn, ivec2(p0.x, p1.y), 0) + x.w * texelFetch(drawn, ivec2(p3.x, p1.y), 0));
  sum += y.z * (x.x * texelFetch(drawn, ivec2(p0.x, p2.y), 0) + x.w * texelFetch(drawn, ivec2(p3.x, p2.y), 0));
  sum += y.w * (x.y * texelFetch(drawn, ivec2(p1.x, p3.y), 0) + x.z * texelFetch(drawn, ivec2(p2.x, p3.y), 0));
  return clamp(sum / (1.0 - (x.x + x.w) * (y.x + y.w)), low, high);
}

// Mean of the drawn pixels that a picture's pixel covers.
vec4 gather(ivec2 pixel) {
  if (scale == 1.0) return texelFetch(drawn, pixel, 0);
  if (scale < 1.0) return enlarge(pixel);
  vec2 low = vec2(pixel) * scale, high = low + scale;
  vec4 sum = vec4(0.0);
  float total = 0.0;
  for (int y = int(floor(low.y)); y < int(ceil(high.y)); ++y) {
    for (int x = int(floor(low.x)); x < int(ceil(high.x)); ++x) {
      float weight = max(0.0, min(high.x, float(x) + 1.0) - max(low.x, float(x))) *
                     max(0.0, min(high.y, float(y) + 1.0) - max(low.y, float(y)));
      sum += weight * texelFetch(drawn, clamp(ivec2(x, y), ivec2(0), textureSize(drawn, 0) - 1), 0);
      total += weight;
    }
  }
  return sum / total;
}
