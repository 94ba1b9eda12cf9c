// The model's own colour: own_colour of renderer/raster/skin_light-inl.h, image_colour of renderer/optics/colours-inl.h.
layout(std430, binding = corners_storage) readonly buffer Corners { uint corners[]; };  // FurCorner; `image` is an int among floats
// Width, height and first texel of each mip level, then the texels.
layout(std430, binding = texels_storage) readonly buffer Texels { uint texels[]; };

float corner_float(uint at) { return uintBitsToFloat(corners[at]); }

float mixed_corner(TriangleCorners at, uint number) {
  uint first = 3 * corner_words * at.triangle + number;
  float a = corner_float(first), b = corner_float(first + corner_words), c = corner_float(first + 2 * corner_words);
  return a + at.b * (b - a) + at.c * (c - a);
}

vec3 linear_texel(uint word) {
  vec3 stored = unpackUnorm4x8(word).rgb;
  return mix(pow((stored + 0.055) / 1.055, vec3(2.4)), stored / 12.92, lessThanEqual(stored, vec3(0.04045)));
}

int wrapped(int at, int side) { return at < 0 ? at + side : at < side ? at : at - side; }

// Returns the colour at uv (v up), interpolated between four texels of the mipmap level that is nearest to the pixel's
// size. `pixel`: that size as a share of the image's side.
vec3 image_colour(vec3 uv, float pixel) {
  if (uv.z < -0.5) return vec3(1.0);
  float largest = float(max(texels[0], texels[1])), lod = clamp(log2(pixel * largest) + 0.5, 0.0, float(texel_levels - 1));
  uint level = 3 * uint(lod);
  ivec2 size = ivec2(texels[level], texels[level + 1]);
  vec2 at = fract(vec2(uv.x, 1.0 - uv.y)) * vec2(size) - 0.5, share = at - floor(at);
  ivec2 low = ivec2(floor(at));
  uint start = 3 * texel_levels + texels[level + 2] + uint(size.x * size.y) * uint(max(uv.z, 0.0) + 0.5);
  vec3 sum = vec3(0.0);
  for (int k = 0; k < 4; ++k) {
    ivec2 off = ivec2(k & 1, k >> 1), texel = ivec2(wrapped(low.x + off.x, size.x), wrapped(low.y + off.y, size.y));
    vec2 part = mix(1.0 - share, share, vec2(off));
    sum += part.x * part.y * linear_texel(texels[start + uint(texel.y * size.x + texel.x)]);
  }
  return sum;
}

// Returns the model's own colour. `pixel` is the size of a pixel there, sizes, and `area` twice the triangle's area.
vec3 model_colour(TriangleCorners at, float pixel, float area) {
  if (!model_colours) return frame.skin.rgb;
  vec3 colour = max(vec3(mixed_corner(at, 7), mixed_corner(at, 8), mixed_corner(at, 9)), 0.0);
  if (texel_levels == 0) return colour;
  uint first = 3 * corner_words * at.triangle + 5;
  vec2 uv[3];
  for (uint k = 0; k < 3; ++k) uv[k] = vec2(corner_float(first + k * corner_words), corner_float(first + k * corner_words + 1));
  vec2 side = uv[1] - uv[0], other = uv[2] - uv[0];
  float on_image = abs(side.x * other.y - side.y * other.x);
  vec3 where = vec3(mixed_corner(at, 5), mixed_corner(at, 6), float(int(corners[first + 5])));
  return colour * image_colour(where, pixel * sqrt(on_image / max(area, 1e-20)));
}
