#version 450 core
// Which set of shells a pixel gets: the one that the outermost fur there asks for.
in float wanted_level;

uniform int shell_lod;
uniform float dithered_levels;  // over how much of a level pixels of two sets are mixed

// Of 4 x 4 pixels, ordered (Bayer 1973), in (-.5, .5).
float dither() {
  ivec2 at = ivec2(gl_FragCoord.xy);
  int both = at.x ^ at.y;
  int order = (both & 1) << 3 | (at.y & 1) << 2 | (both & 2) | (at.y & 2) >> 1;
  return (float(order) + 0.5) / 16.0 - 0.5;
}

void main() {
  if (int(floor(wanted_level + 0.5 + dithered_levels * dither())) != shell_lod) discard;
}
