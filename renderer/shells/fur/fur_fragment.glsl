// The fragment shader of a shell. The including file defines light_on, which lights a fibre.
#include "frame.glsl"
#include "lighting.glsl"
#include "base_colour.glsl"
#ifdef PATTERN
#include "pattern.glsl"
#endif
#include "slab.glsl"
#include "paint_light.glsl"
#include "fragment.glsl"

layout(early_fragment_tests) in;  // nothing here writes depth

#ifdef PATTERN
in vec3 root;
in vec4 varied;
#endif
in vec3 fibre_tangent;
#ifdef SHADOW_MAPS
in vec4 hull_position;
#endif
in vec3 tile_u;
in vec3 base_uv;
in vec3 base_colour;
flat in vec3 over;

in float density_share;
in float length_share;

const int steps = 2;  // texture samples inside a shell's slab where every shell is drawn

#ifdef PAINT_COLOUR
const float mean_level = 7.0;  // mip level whose texels hold the mean of many strands

float lightness_over(vec3 strand, vec3 mean) {
  return clamp(luminance(strand) / max(luminance(mean), 1e-4), 0.5, 1.6);
}
#endif

vec3 light_on(Fibre fibre, vec4 hull);

// Returns the premultiplied light of a slab.
vec4 lit(Slab slab, vec3 normal) {
  float share = 1.0 / slab.opacity;
  float height = slab.height * share;
  vec4 strand = slab.strand * share;
  vec2 slope = (slab.slope * share * 2.0 - 1.0) * (stored_slope / nominal_length);
  vec3 tangent = normalize(fibre_tangent + tile_u * slope.x + cross(normal, tile_u) * slope.y);
#ifdef PAINT
  vec2 turned = curl_slope(height) + clump_slope(height);
  tangent = normalize(tangent + tile_u * turned.x + cross(normal, tile_u) * turned.y);
#endif
#ifdef TUFTS
  tangent = normalize(tangent + tuft_lean(tuft_here(), height));
#endif
  float above = -0.25 * stored_light * log(max(slab.light * share, 1e-9)) * length_share * dense_here;
  vec3 colour = fur_colour(strand.rgb, base_colour, base_uv);
#ifdef PATTERN
  colour = pattern_colour(root, varied, colour);
#endif
#ifdef PAINT_COLOUR
  vec3 mean = textureLod(colours, vec3(tile, floor(height * float(slice_count))), mean_level).rgb;
  colour = colour_painted(colour, height, lightness_over(strand.rgb, mean * mean));
#endif
#ifdef PAINT
  above *= painted_depth();
  colour = colour_wetted(colour);
#endif
#ifdef SHADOW_MAPS
  vec4 hull = hull_position;
#else
  vec4 hull = vec4(world_position, 0.0);
#endif
  Fibre fibre = Fibre(world_position, normal, tangent, normalize(frame.viewpoint.xyz - world_position), colour,
                      colour_crossed(colour, over), height, above, strand.a, shine);
  vec3 light = light_on(fibre, hull);
  return vec4(light * slab.opacity, slab.opacity);
}

void main() {
  compute_derivatives();
  if (lists_full()) discard;
  vec3 normal = normalize(fibre_normal);
#ifdef TUFTS
  shift_to_strand(normal, tile_u);
#endif
  float thickness = shell_thickness();
  Slab slab = march(steps_in_slab(steps), 0.0, density_share, shell_height(), thickness);
  if (!(slab.opacity > min_opacity * thickness)) discard;
  put_fragment(lit(slab, normal));
}
