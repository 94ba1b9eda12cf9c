// Ray marching through the slab of one shell.
#include "constants.glsl"
layout(binding = shapes_unit) uniform sampler2DArray shapes;   // slope, light from above, optical depth
layout(binding = colours_unit) uniform sampler2DArray colours;  // strand colour (square root), number

uniform int shell_count;
uniform int shell;
uniform int shell_side;  // 1: seen from outside, the top of the slab is in front; -1: from inside

in vec3 world_position;
in vec3 fibre_normal;
in vec2 tile;
in vec2 pixel_speed;
in float max_crossing;
in float level;
in float slant;

// Height of the slab's middle and the slab's thickness, over the height of the fur.
#ifdef SHELL_LOD
in float slab_middle, slab_thickness;
float shell_height() { return slab_middle; }
float shell_thickness() { return slab_thickness; }
int steps_in_slab(int step_count) {  // as dense as if every shell were drawn
  const int max_steps = 16;
  return clamp(int(ceil(float(step_count * shell_count) * slab_thickness - 0.01)), 1, max_steps);
}
#else
float shell_height() { return (float(shell) + 0.5) / float(shell_count); }
float shell_thickness() { return 1.0 / float(shell_count); }
int steps_in_slab(int step_count) { return step_count; }
#endif

vec2 tile_per_height;  // derivative of the tile position along the ray by the height, tiles

// Density of strands relative to the tile. Where skin is curved or strands lean apart, shells get larger, but strands
// do not get wider: this is the area of a patch of the tile over that of the same patch of the shell.
float dense_here;

float density_here() {
  float on_tile = abs(determinant(mat2(dFdx(tile), dFdy(tile)))) / (frame.tile.x * frame.tile.x);
  float area = abs(dot(cross(dFdx(world_position), dFdy(world_position)), fibre_normal));
  return clamp(on_tile / max(area, 1e-30), 0.16, 1.7);  // folds would give any value
}

// Computes everything that needs derivatives between pixels; call it first. As the height rises, the tile position that
// a pixel sees moves against the motion of the strands on the screen: correct to first order on curved skin, in
// perspective and where the length changes.
void compute_derivatives() {
  dense_here = density_here();
  vec2 offset = -(dFdx(tile) * pixel_speed.x + dFdy(tile) * pixel_speed.y);
  float far = length(offset);
  tile_per_height = far < 1e6 ? offset * min(1.0, max_crossing / max(far, 1e-9)) : vec2(0.0);
}

#ifdef TUFTS
#include "tufts.glsl"

vec2 tuft_shift = vec2(0.0);  // tiles

// Moves the tile position to the strand that is seen at the middle of the slab, and with it its holes, shadow and
// colour.
void shift_to_strand(vec3 normal, vec3 tile_u) {
  vec3 offset = tuft_offset(tuft_here(), shell_height());
  tuft_shift = vec2(dot(offset, tile_u), dot(offset, cross(normal, tile_u))) * frame.tile.x;
}
#endif

#include "paint.glsl"
#include "paint_form.glsl"

const float min_opacity = 0.002;  // of the whole height: half a step of 255

// All members but `opacity` are weighted by opacity. `light` is the stored light to the fourth power: the transmittance
// of dark strands.
struct Slab {
  float opacity, height, light;
  vec2 slope;
  vec4 strand;  // colour (linear), number
};
const Slab no_slab = Slab(0.0, 0.0, 0.0, vec2(0.0), vec4(0.0));

// Returns the tile position of the strand that the ray crosses at height s.
vec2 tile_at(float s) {
  vec2 at = tile + tile_per_height * (s - shell_height());
#ifdef TUFTS
  at += tuft_shift;
#endif
#ifdef PAINT
  at += clump_shift - curl_offset(s) * frame.tile.x;
#endif
  return at;
}

// Returns the depth scale for this ray's angle to the stack, from those along it and at 60, 30 and 75 degrees; linear
// in the sine between them.
float depth_scale_of(vec4 scales) {
  float sine = sqrt(1.0 - 1.0 / max(slant * slant, 1.0));
  if (sine < 0.5) return mix(scales.x, scales.z, 2.0 * sine);
  if (sine < 0.8660254) return mix(scales.z, scales.y, (sine - 0.5) * 2.7320508);
  return mix(scales.y, scales.w, min((sine - 0.8660254) * 10.0102, 1.0));
}

// Marches front to back in `steps` texture steps through a part of the slab: `thickness` about the height `middle`. The
// stored optical depth is that of one slice seen along the stack, read `blur` levels coarser than the pixel needs. It
// is scaled by the step's thickness, by the slant of the ray, by the factor that preserves the transmittance of its mip
// level (science.md 1), and by `share`.
Slab march(int steps, float blur, float share, float middle, float thickness) {
  share *= dense_here;
#ifdef TUFTS
  share *= tuft_share(tuft_here(), shell_height());
#endif
#ifdef PAINT
  if (amounts.x <= 0.0) return no_slab;
  share *= amounts.y * gather_to_clump(shell_height());
#endif
  float sharp = clamp(floor(level + blur + 0.5), 0.0, 7.0);
  float scale = stored_depth * 1.442695 * share * depth_scale_of(frame.depth_scale[int(sharp)]) * clamp(slant, 1.0, 10.0) *
                float(slice_count) * thickness / float(steps);
  float texels = exp2(9.0 - sharp);  // along a side: slice_texels at the finest level
  Slab slab = no_slab;
  for (int i = 0; i < steps; ++i) {
    float off = (0.5 - (float(i) + 0.5) / float(steps)) * thickness * float(shell_side);
    float s = middle + off;
    vec2 at = tile_at(s);
    float slice = floor(s * float(slice_count));
    vec4 shape = textureLod(shapes, vec3(at, slice), sharp);
#ifdef PAINT
    shape.a *= strand_share(at, int(slice), sharp);
#endif
    float weight = (1.0 - slab.opacity) * (1.0 - exp2(-scale * shape.a));
    slab.opacity += weight;
    slab.height += weight * s;
    float fourth = shape.b * shape.b;
    slab.light += weight * fourth * fourth;
    slab.slope += weight * shape.xy;
    ivec2 texel = ivec2(floor(at * texels)) & (int(texels) - 1);
    vec4 strand = texelFetch(colours, ivec3(texel, int(slice)), int(sharp));
    slab.strand += weight * vec4(strand.rgb * strand.rgb, strand.a);
    if (slab.opacity > 0.985) break;
  }
  return slab;
}
