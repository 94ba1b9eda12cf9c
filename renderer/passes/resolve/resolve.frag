#version 450 core
// From premultiplied linear light to the picture: size, exposure, tone map, background, sRGB.

layout(binding = 0) uniform sampler2D drawn;

uniform float exposure;     // factor
uniform int filmic;         // 1: the filmic curve
uniform int transparent;    // 1: straight alpha instead of a background
uniform float background_r; // linear
uniform float background_g;
uniform float background_b;
uniform float scale;        // drawn size over picture size

layout(location = 0) out vec4 result;

vec3 to_srgb(vec3 linear) {
  vec3 low = 12.92 * linear, high = 1.055 * pow(max(linear, vec3(0.0031308)), vec3(1.0 / 2.4)) - 0.055;
  return mix(high, low, lessThan(linear, vec3(0.0031308)));
}

// A shoulder and a toe (Narkowicz 2015, a fit of the ACES curve), scaled so that .18 stays about .18.
vec3 film(vec3 x) {
  x *= 0.72;
  return clamp(x * (2.51 * x + 0.03) / (x * (2.43 * x + 0.59) + 0.14), 0.0, 1.0);
}

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

void main() {
  vec4 pixel = gather(ivec2(gl_FragCoord.xy));
  float alpha = clamp(pixel.a, 0.0, 1.0);
  vec3 colour = alpha > 0.0 ? pixel.rgb / alpha * exposure : vec3(0.0);
  colour = filmic == 1 ? film(min(colour, 1e4)) : clamp(colour, 0.0, 1.0);
  vec3 background = vec3(background_r, background_g, background_b);
  result = transparent == 1 ? vec4(to_srgb(colour), alpha) : vec4(to_srgb(mix(background, colour, alpha)), 1.0);
}
