#version 450 core
#include "frame.glsl"
#include "known.glsl"
#include "lighting.glsl"
#include "base_colour.glsl"
#ifdef PATTERN
#include "pattern.glsl"
#endif
#include "paint_light.glsl"
#if defined(BARE_SKIN) || defined(PAINT)
#include "bare_skin.glsl"
#endif


in vec3 world_position;
#ifdef SHADOW_MAPS
in vec4 hull_position;
#endif
in vec3 skin_normal;
in vec3 fur_offset;
in vec3 base_uv;
in vec3 base_colour;
in float fur_length;
#ifdef PATTERN
in vec4 varied;
#endif

layout(location = 0) out vec4 result;

/// Returns 1 where fur rises out of the triangle's visible side, 0 in a fold where it grows into the body and no shell shows.
float rising_from_face() {
  vec3 across = cross(dFdx(world_position), dFdy(world_position));
  across = dot(across, frame.viewpoint.xyz - world_position) < 0.0 ? -across : across;
  float size = length(across) * length(fur_offset);
  return size > 0.0 ? smoothstep(-0.1, 0.15, dot(across, fur_offset) / size) : 1.0;
}

// Skin without fur is lit as a matt surface; regions of bare skin have their own shading. Under fur lies an undercoat: the
// colour of the roots in the light that reaches them. The inner side of an open model shows no fur, and neither does a fold
// where fur grows into the body: both are lit as a matt surface of the fur's mean colour.
void main() {
  vec3 normal = normalize(skin_normal);
  if (!gl_FrontFacing) normal = -normal;
  float grown = smoothstep(0.0, 0.008, fur_length), above = frame.depth_above[0].x * fur_length / nominal_length;
#ifdef PAINT
  grown *= 1.0 - pow(1.0 - clamp(amounts.x, 0.0, 1.0), 3.0);  // thinned fur does not hide the skin
  above *= painted_depth();
#endif
  float furred = gl_FrontFacing ? grown : 0.0;
  furred *= rising_from_face();
  float covered = furred;
  vec3 bare = takes_model_colours() ? model_colour(base_colour, base_uv) : frame.skin.rgb;
  vec3 undercoat = fur_colour(frame.ramp_root.rgb, base_colour, base_uv);
#ifdef PATTERN
  undercoat = pattern_colour(world_position, varied, undercoat);
#endif
#ifdef PAINT_COLOUR
  undercoat = colour_painted(undercoat, 0.0, 1.0);
#endif
#ifdef PAINT
  undercoat = colour_wetted(undercoat);
#endif
  vec3 coat = colour_crossed(undercoat, colour_above(0.0));
  vec3 colour = mix(bare, mix(coat, undercoat, furred), grown), crossed = mix(bare, coat, furred);
  vec3 share = mix(vec3(1.0), ambient_share(0.0, above, stopped_by_strand(crossed, 0.6)), covered);
  vec3 sum = frame.weights.x * share * colour * environment_light(normal);
  for (uint i = 0; i < LIGHTS; ++i) {
    Arriving light = light_at(i, world_position);
    float facing = dot(normal, light.to_light);
    float lit = frame.weights.y * max(facing, 0.0) * mix(1.0, 0.6, covered);
    float to_skin = covered * strands_crossed(above, exit_path_length(0.0, facing), normal, light.to_light);
#ifdef SHADOW_MAPS
    to_skin = shell_depth(int(i), world_position, hull_position, 0.0, facing, to_skin);
    light.radiance *= cast_visibility(int(i), world_position, hull_position, normal);
#endif
    sum += light.radiance * colour * lit * transmittance(to_skin, crossed);
  }
#if defined(BARE_SKIN) || defined(PAINT)
  float pixel = frame.viewpoint.w * distance(frame.viewpoint.xyz, world_position);
#ifdef PAINT
  Bare region = painted_bare(bare, amounts.w, amounts.z);
#else
  Bare region = painted_bare(bare, 0.0, 0.0);
#endif
#ifdef BARE_SKIN
  region = bare_over(region, world_position, normal, pixel);
#endif
  if (region.share > 0.0) {
#ifdef SHADOW_MAPS
    vec4 hull = hull_position;
#else
    vec4 hull = vec4(world_position, 0.0);
#endif
    sum = mix(sum, bare_light(region, world_position, hull, normal, pixel), region.share);
  }
#endif
  result = known(vec4(sum, 1.0));
}
