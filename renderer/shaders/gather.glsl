layout(binding = 0) uniform sampler2D drawn;

uniform float scale;  // drawn size over picture size

// Mean of the drawn pixels that a picture's pixel covers; bilinear where it was drawn smaller.
vec4 gather(ivec2 pixel) {
  ivec2 size = textureSize(drawn, 0);
  if (scale == 1.0) return texelFetch(drawn, pixel, 0);
  vec2 low = vec2(pixel) * scale, high = low + scale;
  if (scale < 1.0) {
    vec2 at = (vec2(pixel) + 0.5) * scale - 0.5;
    low = at, high = at + 1.0;
  }
  vec4 sum = vec4(0.0);
  float total = 0.0;
  for (int y = int(floor(low.y)); y < int(ceil(high.y)); ++y) {
    for (int x = int(floor(low.x)); x < int(ceil(high.x)); ++x) {
      float weight = max(0.0, min(high.x, float(x) + 1.0) - max(low.x, float(x))) *
                     max(0.0, min(high.y, float(y) + 1.0) - max(low.y, float(y)));
      sum += weight * texelFetch(drawn, clamp(ivec2(x, y), ivec2(0), size - 1), 0);
      total += weight;
    }
  }
  return sum / total;
}
