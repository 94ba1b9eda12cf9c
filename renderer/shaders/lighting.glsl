// Light on fur: what arrives, what gets through, and what a fibre sends to the camera.
#include "constants.glsl"

#ifdef SHADOW_MAPS
#include "shadow.glsl"
#endif

#include "scattering.glsl"

#ifndef LIGHTS
#define LIGHTS int(frame.counts.z)  // of any frame; a number that is known when it is compiled makes light cheaper
#endif
#ifndef SHADING_MODEL
#define SHADING_MODEL model_kajiya
#endif

// Where the light comes from, unit, and what arrives at the place. FAR_LIGHTS: none stands at a place.
void light_at(int i, vec3 place, out vec3 to_light, out vec3 radiance) {
  Light light = frame.lights[i];
#ifdef FAR_LIGHTS
  to_light = -light.direction.xyz;
  radiance = light.radiance.rgb;
#else
  vec3 apart = light.position.xyz - place;
  float square = max(dot(apart, apart), min_light_square);
  bool point = light.direction.w > 0.5;
  to_light = point ? apart * inversesqrt(square) : -light.direction.xyz;
  radiance = light.radiance.rgb * (point ? min(1.0 / square, max_light_falloff) : 1.0);
  float inside = dot(-to_light, light.direction.xyz), edge = light.position.w;
  radiance *= clamp((inside - edge) / max(light.radiance.w - edge, 1e-6), 0.0, 1.0);
#endif
}

// Share of the light that a strand of that colour stops. Light that passes pale fur keeps its colour and much of its
// strength: t_c = t^(1 - f_c) (science.md 4), with t = exp(-2) past a black strand, to the power of `part`.
vec3 stopped_by_strand(vec3 colour, float part) {
  return 1.0 - exp2(-2.0 * 1.442695 * part * frame.exponents.w * (1.0 - 0.82 * sqrt(clamp(colour, 0.0, 1.0))));
}

// Mean of what gets through on rays that cross so many strands on average, by chance: that of a Poisson distribution.
vec3 transmittance(float strands, vec3 colour) { return exp2(-1.442695 * strands * stopped_by_strand(colour, 1.0)); }

// How far a ray goes through the fur to get out of it, over the height above where it sets out: the further the lower it
// points. Out of a height h below the tips, over a body of radius r, h 2 / (n.d + sqrt((n.d)^2 + 2 h / r)).
float way_out(float height, float facing) {
  float roundness = 0.2 * (1.0 - height) + 0.01;  // 2 h / r, where fur is a tenth of the radius of what it grows on
  return 2.0 / (facing + sqrt(facing * facing + roundness));
}

// Strands that a ray crosses on its way out, of `above` that one at 45 degrees to upright fur would cross: it meets them by
// the sine of its angle to them.
float strands_crossed(float above, float height, vec3 tangent, vec3 direction, float facing) {
  const float spread = 0.08;  // strands of one place differ in direction
  float along = dot(tangent, direction);
  return above * sqrt(1.0 - (1.0 - spread) * min(along * along, 1.0)) * way_out(height, facing);
}

#ifdef PAINT_COLOUR
vec4 paint_above = vec4(0.0);  // of the fur over a strand: times its cover, cover
#endif

// Colour of the fur above a height over the colour there.
vec3 colour_above(float height) {
  return frame.colour_above[clamp(int(height * float(slice_count)), 0, slice_count - 1)].rgb;
}

// Light on its way to a strand of that colour crosses the fur above it, which may be paler or darker.
vec3 colour_crossed(vec3 colour, vec3 over) {
  vec3 crossed = colour * over;
#ifdef PAINT_COLOUR
  crossed = crossed * (1.0 - paint_above.a) + paint_above.rgb;
#endif
  return crossed;
}

// Share of the light from all around that gets to a height: g of GPU fur eq 1, with s where nothing better is known.
// Where the self-shadow knows the fur above, it takes the place of s; both together would darken the same fur twice.
// From a direction at the angle x to the normal it crosses `above` tan x strands and is weighed by cos x. The mean of
// exp(-a tan x) over the half sphere falls by pi/2 a at first and as 2 over the square of a at last; this is within .01.
vec3 ambient_share(float height, float above, vec3 crossed) {
  vec3 a = above * stopped_by_strand(crossed, 0.6);
  vec3 reached = (1.0 + a) / (1.0 + a * (2.5707963 + a * (1.21 + a * 0.5)));
  vec3 open = mix(vec3(height), reached, min(frame.exponents.w, 1.0));
  return mix(vec3(frame.weights.w), vec3(1.0), open);
}

// Light from all around on a surface with that normal; 1 for a white surrounding.
vec3 environment_light(vec3 n) {
#ifdef ENVIRONMENT
  vec3 sum = 0.28209479 * frame.environment[0].rgb;
  sum += 0.48860251 * (n.y * frame.environment[1].rgb + n.z * frame.environment[2].rgb + n.x * frame.environment[3].rgb);
  sum += 1.09254843 * (n.x * n.y * frame.environment[4].rgb + n.y * n.z * frame.environment[5].rgb +
                       n.x * n.z * frame.environment[7].rgb);
  sum += 0.31539157 * (3.0 * n.z * n.z - 1.0) * frame.environment[6].rgb;
  sum += 0.54627422 * (n.x * n.x - n.y * n.y) * frame.environment[8].rgb;
  return max(sum, 0.0);
#else
  return vec3(1.0);
#endif
}

// What a bundle sends back after many fibres. The fibre models scatter once; without the rest, pale fur turns grey and
// red fur brown (dual scattering in spirit; science.md 4).
vec3 scatter_again(vec3 tangent, vec3 to_light, vec3 colour) {
  float along = dot(tangent, to_light);
  return 0.55 * scattering.weights.x * colour * sqrt(max(0.0, 1.0 - along * along));
}


struct Fibre {
  vec3 place;
  vec4 open;      // where light comes to it that other parts of the body let through; how high the fur's hull is there, sizes
  vec3 normal, tangent, to_camera;
  vec3 colour;    // C
  vec3 over;      // colour of the fur above over C
  float height;   // s in [0, 1]
  float above;    // strands over the place that a ray at 45 degrees to upright fur would cross
  float strand;   // number of the strand in [0, 1]
};

// Strands on the way to the light that are not met for sure, as the eye looks past them: the hot spot of leaf canopies
// (Kuusk 1985, "The hot spot effect of a uniform vegetative cover"). Of N to the camera and M to the light, rays that move
// apart by d widths of a strand share sqrt(N M) (1 - exp(-x)) / x, x = d / c; they may move apart along the strands. c would be
// 1/2 for any place in the fur. What one sees stands out of what is around it: 1/6 gives furry balls strands' light, within
// .03 from the side and from above, lying and upright.
float strands_shared(Fibre fibre, vec3 to_light, float facing, float to_light_strands) {
  float view_facing = dot(fibre.normal, fibre.to_camera);
  float to_camera_strands = strands_crossed(fibre.above, fibre.height, fibre.tangent, fibre.to_camera, view_facing);
  vec3 apart = fibre.to_camera * way_out(fibre.height, view_facing) - to_light * way_out(fibre.height, facing);
  apart -= dot(apart, fibre.tangent) * fibre.tangent;
  float widths = fibre.above / max(frame.counts.y, 1e-6) * max(dot(fibre.tangent, fibre.normal), 0.15);  // of the fur above
  float x = 6.0 * widths * length(apart);
  float share = (1.0 + x / 6.0) / (1.0 + x * (0.66666667 + x / 6.0));  // (1 - exp(-x)) / x within .02
  return sqrt(to_camera_strands * to_light_strands) * share;
}

float strands_to_light(Fibre fibre, vec3 to_light, float facing) {
  float strands = strands_crossed(fibre.above, fibre.height, fibre.tangent, to_light, facing);
  return max(strands - strands_shared(fibre, to_light, facing, strands), 0.0);
}

// Light that a fibre sends to the camera, after GPU fur eq 1 to 3: each light is scattered by the look's shading model.
vec3 fibre_light(Fibre fibre) {
  vec3 crossed = colour_crossed(fibre.colour, fibre.over);
  vec3 sum = frame.weights.x * fibre.colour * ambient_share(fibre.height, fibre.above, crossed) *
             environment_light(fibre.normal);
  for (int i = 0; i < LIGHTS; ++i) {
    vec3 to_light, radiance;
    light_at(i, fibre.place, to_light, radiance);
    float facing = dot(fibre.normal, to_light);
    float strands = strands_to_light(fibre, to_light, facing);
#ifdef SHADOW_MAPS
    strands = shell_depth(i, fibre.place, fibre.open, fibre.height, facing, strands);
    radiance *= cast_light(i, fibre.place, fibre.open, fibre.normal);
#endif
    vec3 scattered = scatter(SHADING_MODEL, fibre.tangent, fibre.normal, to_light, fibre.to_camera, fibre.colour, fibre.strand);
    if (SHADING_MODEL == model_energy_conserving || SHADING_MODEL == model_marschner) {
      scattered = 0.6 * scattered + scatter_again(fibre.tangent, to_light, fibre.colour);
    }
    sum += radiance * scattered * transmittance(strands, crossed) *
           light_behind(SHADING_MODEL, facing, frame.exponents.z);
  }
  return sum;
}
