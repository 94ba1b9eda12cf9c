// Markings and slow changes over the body by where a root is (internal coordinates). renderer/pattern holds the same
// formulas for the CPU and tests/gl compares both on a grid; renderer/pattern/pattern_block.h mirrors the block.
layout(std140, binding = 1) uniform PatternBlock {
  uvec4 head;         // kind, seed
  vec4 shape;         // markings per size, coverage, softness, warp
  vec4 amounts;       // contrast, inner, legs, belly
  vec4 axis;          // unit; w: 1 / the largest luminance of the ramp
  vec4 colour;
  vec4 inner_colour;
  vec4 belly_colour;
  vec4 variation;     // lightness, hue, length, lean
  vec4 derived;       // swells per size, radius of spots, threshold of patches
} pattern;

const uint kind_none = 0u, kind_stripes = 1u, kind_spots = 2u, kind_rosettes = 3u, kind_tabby = 4u, kind_patches = 5u,
           kind_countershading = 6u;

// PCG3D (Jarzynski, Olano 2020): three numbers in [0, 1) for a cell.
vec3 pattern_random(ivec3 cell, uint stream) {
  uvec3 v = uvec3(cell) + (pattern.head.y * 0x9e3779b9u + stream * 0x85ebca6bu) * uvec3(1u, 0xc2b2ae35u, 0x27d4eb2fu);
  v = v * 1664525u + 1013904223u;
  v.x += v.y * v.z;
  v.y += v.z * v.x;
  v.z += v.x * v.y;
  v ^= v >> 16u;
  v.x += v.y * v.z;
  v.y += v.z * v.x;
  v.z += v.x * v.y;
  return vec3(v >> 8u) * (1.0 / 16777216.0);
}

float pattern_slope(ivec3 cell, ivec3 corner, vec3 inside, uint stream) {
  return dot(2.0 * pattern_random(cell + corner, stream) - 1.0, inside - vec3(corner));
}

// Gradient noise (Perlin 2002) of one swell per unit: mean 0, standard deviation .19, seldom beyond +-.6.
float pattern_noise(vec3 place, uint stream) {
  vec3 low = floor(place), f = place - low;
  ivec3 cell = ivec3(low);
  vec3 w = f * f * f * (f * (f * 6.0 - 15.0) + 10.0);
  float sums[4];
  for (int i = 0; i < 4; ++i) {
    ivec3 corner = ivec3(0, i & 1, i >> 1);
    sums[i] = mix(pattern_slope(cell, corner, f, stream), pattern_slope(cell, corner + ivec3(1, 0, 0), f, stream), w.x);
  }
  return mix(mix(sums[0], sums[1], w.y), mix(sums[2], sums[3], w.y), w.z);
}

// Distance along the surface to the nearest of points scattered one to a unit cell, each with a size of its own that
// shrinks to nothing for points half a unit off the surface. Points stay in the middle of their cells, so that the
// eight nearest cells are enough up to the largest value that is given back.
float pattern_cells(vec3 place, vec3 normal, uint stream) {
  ivec3 cell = ivec3(floor(place - 0.5));
  float nearest = 0.62;
  for (int i = 0; i < 8; ++i) {
    ivec3 at = cell + ivec3(i & 1, (i >> 1) & 1, i >> 2);
    vec3 random = pattern_random(at, stream);
    vec3 apart = vec3(at) + 0.2 + 0.6 * random - place;
    float off = dot(apart, normal);
    float size = (0.8 + 0.3 * fract(random.x * 16.0)) * (1.0 - smoothstep(0.3, 0.5, abs(off)));
    nearest = min(nearest, length(apart - off * normal) / max(size, 1e-3));
  }
  return nearest;
}

// 1 where x is below the threshold, with a soft edge of the given half width.
float pattern_below(float x, float threshold, float soft) {
  return 1.0 - smoothstep(threshold - soft, threshold + soft, x);
}

// 0 on the trunk, 1 on legs.
float pattern_on_legs(vec3 place) { return pattern.amounts.z * (1.0 - smoothstep(-0.2, -0.1, place.y)); }

// Counts stripes along the axis; on legs and haunches they turn to lie around the leg, on haunches swept to the rump.
float pattern_stripe_count(vec3 place) {
  float along = dot(place, pattern.axis.xyz);
  float haunch = 1.0 - smoothstep(-0.25, 0.0, along);
  float drop = max(mix(-0.08, 0.06, haunch) - place.y, 0.0);
  float turned = along + 2.4 * pattern.amounts.z * mix(1.0, -1.0, haunch) * drop * drop / (drop + 0.08);
  return turned * pattern.shape.x + 2.0 * pattern.shape.w * pattern_noise(0.4 * pattern.shape.x * place, 0u);
}

// 0 in the middle of a stripe, 1 between stripes. Noise drawn out along the stripes joins, splits and ends them.
float pattern_stripe(vec3 place, float ragged) {
  float count = pattern_stripe_count(place);
  vec3 axis = pattern.axis.xyz;
  vec3 drawn_out = 0.3 * pattern.shape.x * (place - axis * dot(place, axis)) + axis * (0.8 * count);
  float between = abs(fract(count) - 0.5) * 2.0;
  float coverage = pattern.shape.y;
  return between + 4.0 * coverage * (1.0 - coverage) * ragged * pattern.shape.w * pattern_noise(drawn_out, 1u);
}

float pattern_soft(float coverage) { return pattern.shape.z * min(coverage, 1.0 - coverage) + 1e-3; }

// x: marking, y: inner colour, both in [0, 1].
vec2 pattern_stripes(vec3 place) {
  float stripe = pattern_stripe(place, 1.8), coverage = pattern.shape.y;
  return vec2(pattern_below(stripe, coverage, pattern_soft(coverage)), smoothstep(0.78, 0.9, stripe));
}

vec2 pattern_tabby(vec3 place, vec3 normal) {
  float coverage = pattern.shape.y, soft = pattern_soft(coverage);
  float breaks = 2.4 * coverage * (1.0 - coverage) * pattern.shape.w * pattern_noise(0.8 * pattern.shape.x * place, 2u);
  float broken = pattern_stripe(place, 2.6) + breaks;
  float spine = pattern_below(abs(place.x) * pattern.shape.x, 0.5 * coverage, soft) * smoothstep(0.2, 0.5, normal.y);
  return vec2(max(pattern_below(broken, coverage, soft), spine), smoothstep(0.7, 0.9, broken));
}

// Distance from the middle of a spot: 1 at its edge, which noise makes uneven.
float pattern_spot(vec3 place, vec3 normal) {
  vec3 at = place * pattern.shape.x;
  float uneven = 1.0 + 0.9 * pattern.shape.w * pattern_noise(2.0 * at, 4u);
  return pattern_cells(at, normal, 3u) * uneven / max(pattern.derived.y, 1e-4);
}

vec2 pattern_spots(vec3 place, vec3 normal) {
  return vec2(pattern_below(pattern_spot(place, normal), 1.0, 0.5 * pattern.shape.z + 1e-3), 0.0);
}

// Rings that are broken in places; on the legs they are filled, and smaller.
vec2 pattern_rosettes(vec3 place, vec3 normal) {
  float legs = pattern_on_legs(place), soft = 0.5 * pattern.shape.z + 1e-3;
  float spot = pattern_spot(place, normal) * (1.0 + 0.5 * legs);
  float disc = pattern_below(spot, 1.0, soft), hollow = pattern_below(spot, 0.62, soft);
  float gap = pattern_below(pattern_noise(1.9 * pattern.shape.x * place, 5u), -0.07, 0.05);
  float ring = disc * (1.0 - hollow) * (1.0 - gap);
  return vec2(mix(ring, disc, legs), disc);
}

float pattern_patch(vec3 place, uint stream) {
  vec3 at = 0.6 * pattern.shape.x * place;
  float ragged = 0.5 * pattern.shape.w * pattern_noise(2.7 * at, stream + 1u);
  return pattern_below(pattern_noise(at, stream) + ragged, pattern.derived.z, 0.2 * pattern.shape.z + 1e-3);
}

vec2 pattern_marks(vec3 place, vec3 normal) {
  switch (pattern.head.x) {
    case kind_stripes: return pattern_stripes(place);
    case kind_spots: return pattern_spots(place, normal);
    case kind_rosettes: return pattern_rosettes(place, normal);
    case kind_tabby: return pattern_tabby(place, normal);
    case kind_patches: return vec2(pattern_patch(place, 6u), pattern_patch(place, 8u));
    default: return vec2(0.0);
  }
}

// 1 on what is turned down and low, 0 on the back; `reach` in [0, 1] is how far up it goes.
float pattern_under(vec3 place, vec3 normal, float reach, float soft) {
  float down = -0.9 * normal.y - 0.5 * place.y + 0.25 * pattern_noise(9.0 * place, 10u);
  float threshold = mix(1.4, -1.4, reach);
  return smoothstep(threshold - soft, threshold + soft, down);
}

// -1 to 1, slowly over the body.
float pattern_swell(vec3 place, uint stream) {
  return clamp(1.8 * pattern_noise(pattern.derived.x * place, stream), -1.0, 1.0);
}

vec3 pattern_varied(vec3 place, vec3 colour) {
  if (pattern.variation.x > 0.0) colour *= exp2(pattern.variation.x * pattern_swell(place, 11u));
  if (pattern.variation.y > 0.0) {
    float turn = pattern.variation.y * pattern_swell(place, 12u) / 3.0;
    colour *= vec3(1.0 + turn, 1.0, 1.0 - turn);
  }
  return colour;
}

vec3 pattern_countershaded(vec3 place, vec3 normal, vec3 base, float shade) {
  float soft = 0.1 + pattern.shape.z, reach = pattern.shape.y;
  float back = 1.0 - pattern_under(place, normal, min(reach + 0.3, 1.0), soft);
  vec3 upper = mix(base, pattern.inner_colour.rgb * shade, pattern.amounts.y * back);
  float lower = pattern.amounts.x * pattern_under(place, normal, reach, soft);
  return mix(upper, pattern.belly_colour.rgb * shade, lower);
}

// The colour of a strand whose root is at `place` with this normal (unit) and which would be `base` (linear) without a
// pattern. Markings get lighter and darker along the strand as the base does.
vec3 pattern_colour(vec3 place, vec3 normal, vec3 base) {
  uint kind = pattern.head.x;
  if (kind == kind_none) return pattern_varied(place, base);
  float shade = 0.36 + 0.84 * dot(base, vec3(0.2126, 0.7152, 0.0722)) * pattern.axis.w;
  if (kind == kind_countershading) return pattern_varied(place, pattern_countershaded(place, normal, base, shade));
  vec3 colour = base;
  float kept = 1.0;
  if (pattern.amounts.w > 0.0) {
    float under = pattern.amounts.w * pattern_under(place, normal, 0.36, 0.25);
    colour = mix(colour, pattern.belly_colour.rgb * shade, under);
    kept = 1.0 - under;
  }
  vec2 marks = kept * pattern_marks(place, normal);
  colour = mix(colour, pattern.inner_colour.rgb * shade, pattern.amounts.y * marks.y);
  return pattern_varied(place, mix(colour, pattern.colour.rgb * shade, pattern.amounts.x * marks.x));
}

// Factor on the length of fur, [0, 2].
float pattern_length(vec3 place) {
  return pattern.variation.z > 0.0 ? 1.0 + pattern.variation.z * pattern_swell(place, 13u) : 1.0;
}

// To be added to the inclination, [-1, 1]; the sum is clamped to [0, 1] by who adds it.
float pattern_lean(vec3 place) {
  return pattern.variation.w > 0.0 ? pattern.variation.w * pattern_swell(place, 14u) : 0.0;
}
