#version 450 core
#include "frame.glsl"
#include "lighting.glsl"
#include "base_colour.glsl"
#ifdef PATTERN
#include "pattern.glsl"
#endif
#include "slab.glsl"
#ifdef LAYERS
#include "layers.glsl"
#endif

layout(binding = 1) uniform sampler2DArray colours;  // strand colour (square root), number

in vec3 place;
#ifdef PATTERN
in vec3 root;
in vec4 varied;
#endif
in vec3 fibre_normal;
in vec3 fibre_tangent;
in vec3 tile_u;
in vec3 base_uv;
in vec3 base_colour;

in float density_share;
#ifdef LENGYEL
in vec3 vertex_light;  // for fur of colour 1
#ifdef LAYERS
in vec3 vertex_direct;
in vec2 vertex_share;
#endif
#endif

uniform int band_count;  // parts of the slab that are lit each on its own
uniform int step_count;  // texture steps inside a band

layout(location = 0) out vec4 result;  // premultiplied

Fibre fibre_of(Slab band, vec3 normal) {
  float share = 1.0 / band.opacity;
  float height = band.height * share;
  vec4 texel = textureLod(colours, vec3(tile_at(height), floor(height * float(slice_count))), floor(level + 0.5));
  vec2 slope = (band.slope * share * 2.0 - 1.0) * (stored_slope / nominal_length);
  vec3 tangent = normalize(fibre_tangent + tile_u * slope.x + cross(normal, tile_u) * slope.y);
#ifdef TUFTS
  tangent = normalize(tangent + tuft_lean(tuft_here(), height));
#endif
  float above = -log(max(band.light * share, 0.004));
  vec3 colour = fur_colour(texel.rgb * texel.rgb, base_colour, base_uv);
#ifdef PATTERN
  colour = pattern_colour(root, varied, colour);
#endif
  return Fibre(place, normal, tangent, normalize(frame.eye.xyz - place), colour, height, above, texel.a);
}

vec3 light_of(Fibre fibre) {
#ifdef LENGYEL
#ifdef LAYERS
  direct_light += fibre.colour * vertex_direct;
  light_share += vertex_share;
#endif
  return fibre.colour * vertex_light;
#else
  return fibre_light(fibre);
#endif
}

// Bands from the eye inwards.
void main() {
  vec3 normal = normalize(fibre_normal);
  float deep = 1.0 / float(shell_count * band_count);
  result = vec4(0.0);
#ifdef LAYERS
  clear_layers();
#endif
  for (int i = 0; i < band_count; ++i) {
    float middle = shell_height() + (0.5 * float(band_count - 1) - float(i)) * deep * float(shell_side);
#ifdef TUFTS
    vec3 way = tuft_way(tuft_here(), middle);
    tuft_shift = vec2(dot(way, tile_u), dot(way, cross(normal, tile_u))) * frame.tile.x;
#endif
    Slab band = march_band(middle, deep, step_count, 0.0, density_share);
    if (band.opacity < 0.02 * deep) continue;  // together less than one step of 255 over most of the fur
    float seen = (1.0 - result.a) * band.opacity;
    Fibre fibre = fibre_of(band, normal);
#ifdef LAYERS
    direct_light = vec3(0.0), light_share = vec2(0.0);
#endif
    result += seen * vec4(light_of(fibre), 1.0);
#ifdef LAYERS
    add_layers(fibre.place, fibre.normal, fibre.tangent, fibre.colour, seen);
#endif
    if (result.a > 0.985) break;
  }
  if (result.a == 0.0) discard;
#ifdef LAYERS
  layer_count = vec4(1.0, 0.0, 0.0, 0.0);
#endif
}
