// The model's own colour, and how it affects fur and skin.
#include "constants.glsl"
layout(binding = skin_images_unit) uniform sampler2DArray base_images;  // linear after decoding from sRGB

// Interpolated vertex colours may be negative where a sample lies outside its triangle.
vec3 model_colour(vec3 colour, vec3 uv) {
  colour = max(colour, 0.0);
  if (uv.z < -0.5) return colour;
  return colour * texture(base_images, vec3(uv.x, 1.0 - uv.y, floor(uv.z + 0.5))).rgb;
}

// RAMP_COLOURS makes this known at compile time; otherwise the texture is read even where nobody sees it.
bool takes_model_colours() {
#ifdef RAMP_COLOURS
  return false;
#else
  return frame.skin.w > 0.5;
#endif
}

// Returns the model's hue with the ramp's lightness along the strand; or the ramp's colour alone.
vec3 fur_colour(vec3 strand, vec3 colour, vec3 uv) {
  if (!takes_model_colours()) return strand;
  float lightness = luminance(strand) / frame.tile.w;
  return model_colour(colour, uv) * (0.36 + 0.84 * lightness);
}
