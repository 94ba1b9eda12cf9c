#version 450 core
#include "constants.glsl"
// From premultiplied linear light to the picture: size, exposure, tone map, background, sRGB.
#include "gather.glsl"

uniform float exposure;     // factor
uniform int filmic;         // 1: the filmic curve
uniform int transparent;    // 1: straight alpha instead of a background
uniform float background_r; // linear
uniform float background_g;
uniform float background_b;
#ifdef STUDIO
uniform vec3 picture_size;  // pixels; the third is the largest value of a channel
#endif
#ifdef OVERLAY
layout(binding = overlay_unit) uniform sampler2D overlay;  // sRGB, straight alpha, of the picture's size
#endif

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

#ifdef STUDIO
// A sheet of paper, lit from above: darker towards the top and the corners. Linear.
vec3 studio() {
  vec2 at = gl_FragCoord.xy / picture_size.xy;
  vec2 off = (at - vec2(0.5, 0.55)) * vec2(1.1, 1.0);
  vec3 sheet = mix(vec3(0.30, 0.315, 0.335), vec3(0.62, 0.615, 0.60), smoothstep(-0.1, 1.0, at.y));
  return sheet * (1.0 - 0.55 * smoothstep(0.1, 1.0, 1.6 * dot(off, off)));
}

// Within half a step of a channel, so that the gradient has no bands: interleaved gradient noise (Jimenez 2014).
float dither() {
  float noise = fract(52.9829189 * fract(dot(floor(gl_FragCoord.xy), vec2(0.06711056, 0.00583715))));
  return (noise - 0.5) * 0.98 / picture_size.z;
}
#endif

void main() {
  vec4 pixel = gather(ivec2(gl_FragCoord.xy));
  float alpha = clamp(pixel.a, 0.0, 1.0);
  vec3 colour = alpha > 0.0 ? pixel.rgb / alpha * exposure : vec3(0.0);
  colour = filmic == 1 ? film(min(colour, 1e4)) : clamp(colour, 0.0, 1.0);
  vec3 background = vec3(background_r, background_g, background_b);
#ifdef STUDIO
  background = studio();
#endif
  result = transparent == 1 ? vec4(to_srgb(colour), alpha) : vec4(to_srgb(mix(background, colour, alpha)), 1.0);
#ifdef STUDIO
  result.rgb += dither() * (1.0 - alpha);
#endif
#ifdef OVERLAY
  vec4 over = texelFetch(overlay, ivec2(gl_FragCoord.xy), 0);
  result.rgb = mix(result.rgb, over.rgb, over.a);
  if (over.a == 1.0) result.a = 1.0;  // a map of a light hides the frame and what is transparent there
#endif
}
