// The light that a fibre of shell fur sends to the camera.
#include "constants.glsl"

#ifdef SHADOW_MAPS
#include "shadow.glsl"
#endif

#include "scattering.glsl"

#ifndef LIGHTS
#define LIGHTS int(frame.counts.z)  // for any frame; a number known at compile time is faster
#endif
#ifndef SHADING_MODEL
#define SHADING_MODEL model_kajiya
#endif

#ifdef FAR_LIGHTS
const bool directional_lights = true;  // all lights are directional
#else
const bool directional_lights = false;
#endif
#ifdef ENVIRONMENT
const bool white_surroundings = false;
#else
const bool white_surroundings = true;
#endif
#include "shared/light.glsl"

// Returns the mean transmittance of rays that cross `strands` randomly placed strands on average (Poisson
// distribution).
vec3 transmittance(float strands, vec3 colour) { return exp2(-1.442695 * strands * stopped_by_strand(colour, 1.0)); }

#ifdef PAINT_COLOUR
vec4 paint_above = vec4(0.0);  // paint of the fur above a strand: colour times cover, cover
#endif

// Returns the colour of the fur above a height over the colour there.
vec3 colour_above(float height) {
  return frame.colour_above[clamp(int(height * float(slice_count)), 0, slice_count - 1)].rgb;
}

// Returns the colour of the fur that light crosses on its way to a strand of that colour; it may be paler or darker.
vec3 colour_crossed(vec3 colour, vec3 over) {
  vec3 crossed = colour * over;
#ifdef PAINT_COLOUR
  crossed = crossed * (1.0 - paint_above.a) + paint_above.rgb;
#endif
  return crossed;
}

// Returns the light that a fibre sends to the camera, after GPU fur eq 1 to 3: the look's shading model scatters each
// light. `hull`: position and height of the fur's hull there, sizes, at which light arrives past other parts of the
// body.
vec3 fibre_light(Fibre fibre, vec4 hull) {
  vec3 sum = frame.weights.x * fibre.colour * environment_light(fibre.normal) *
             ambient_share(fibre.height, fibre.above, stopped_by_strand(fibre.crossed, 0.6));
  FibreView view = view_of(fibre);
  FibreViewTerms view_terms;
  if (scatters_fibres(SHADING_MODEL)) view_terms = fibre_view_terms(fibre);
  for (uint i = 0; i < LIGHTS; ++i) {
    Arriving light = light_at(i, fibre.position);
    float facing = dot(fibre.normal, light.to_light), path = exit_path_length(fibre.height, facing);
    float crossed = strands_crossed(fibre.above, path, fibre.tangent, light.to_light);
    float strands = strands_not_shared(fibre, view, light.to_light, path, crossed);
#ifdef SHADOW_MAPS
    strands = shell_depth(int(i), fibre.position, hull, fibre.height, facing, strands);
    light.radiance *= cast_visibility(int(i), fibre.position, hull, fibre.normal);
#endif
    sum += light.radiance * scatter(SHADING_MODEL, fibre, view_terms, light.to_light) * transmittance(strands, fibre.crossed) *
           backlight_fade(SHADING_MODEL, facing, frame.exponents.z);
  }
  return sum;
}
