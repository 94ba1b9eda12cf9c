// The vertex shader of a shell. The including file defines main().
#include "frame.glsl"
#include "lean.glsl"

layout(location = 0) in vec3 position;
layout(location = 1) in vec3 normal;
layout(location = 2) in vec3 tangent;
layout(location = 3) in vec2 tile_uv;
layout(location = 4) in vec3 tile_axis;
layout(location = 5) in vec3 image_uv;  // u, v, image (-1 for none)
layout(location = 6) in vec3 colour;
layout(location = 7) in vec3 groom;     // direction (tangent, bitangent), length
layout(location = 8) in float weight;   // share of the optical depth that this triangle's patch of fur draws
layout(location = 15) in vec3 shading_normal;  // split at creases; fur grows along `normal`
layout(location = 9) in float shell_lod;  // how often the number of shells may be halved
#ifdef PATTERN
layout(location = 10) in vec4 variation;  // factor on length, addition to inclination, factor on lightness, turn of hue
#endif

#include "paint_attributes.glsl"

uniform int shell_count;
uniform int shell;
uniform int shell_side;   // 1 for front-facing triangles, -1 for back-facing ones
#ifdef SHELL_LOD
uniform int max_shell_lod;  // 0: every shell is drawn everywhere
#endif
uniform float push;       // how much further from the camera the depth is written, lengths of the fur

#ifdef SHELL_LOD
out float slab_middle, slab_thickness;  // of the shell's slab, relative to the height of the fur
#include "shell_lod.glsl"
#endif

out vec3 world_position;
#ifdef SHADOW_MAPS
out vec4 hull_position;      // as in skin.vert, but at the shell's height if that is above the hull
#endif
#ifdef PATTERN
out vec3 root;           // where the strand leaves the skin: patterns are anchored there
out vec4 varied;
#endif
#ifdef TUFTS
out vec3 tuft_root;      // where the strand leaves the skin
out float tuft_length;   // of the fur, sizes
#endif
out vec3 fibre_normal;
out vec3 fibre_tangent;
out vec2 tile;           // position on the sample tile at the slab's middle, tiles
out float level;         // mip level of the slices for the size of a pixel here
out vec2 pixel_speed;    // movement of a strand on the picture for a unit of height, pixels
out float max_crossing; // largest length of tile_per_height (slab.glsl)
out float slant;         // length of the ray's path through a slab over its thickness, relative to the strands
out vec3 tile_u;
out vec3 base_uv;
out vec3 base_colour;
flat out vec3 over;      // colour of the fur above this shell divided by the colour in it
out float density_share; // share of the optical depth that this triangle draws
out float length_share;  // length of the fur over nominal_length

// Fades out fur of almost no length, which would otherwise lie like fog on bare skin.
float grown(float fur_length) { return smoothstep(0.0, 0.002, fur_length); }

// Writes all outputs of the vertex. Returns the height of the shell over that of the fur.
float place_vertex() {
#ifdef SHELL_LOD
  float slab_end = slab_begin(shell + 1, shell_lod);
  slab_thickness = (slab_end - slab_begin(shell, shell_lod)) / float(shell_count);
  slab_middle = slab_end / float(shell_count) - 0.5 * slab_thickness;
  float s = slab_middle;
#else
  float s = (float(shell) + 0.5) / float(shell_count);
#endif
  bool root_curve = frame.tile.z > 0.5;
  float inclination = min(length(groom.xy), 1.0), fur_length = groom.z;
#ifdef PATTERN
  root = position;
  varied = variation;
  fur_length *= variation.x;
  inclination = clamp(inclination + variation.y, 0.0, 1.0);
#endif
#ifdef TUFTS
  tuft_root = position;
  tuft_length = fur_length;
#endif
  vec3 lean = lean_along(groom.xy, normal, tangent);
  vec3 curve = lean_point(root_curve, inclination, frame.counts.w, s);
  world_position = position + fur_length * (curve.x * lean + curve.y * normal);
#ifdef SHADOW_MAPS
  hull_position = vec4(position + hull_offset(groom, normal, tangent, root_curve, frame.counts.w, s), hull_height * groom.z);
#endif
  fibre_normal = shading_normal;
  fibre_tangent = lean * sin(curve.z) + normal * cos(curve.z);

  // For a unit of height, the root of the strand that the ray crosses moves by the ray's movement less the strand's lean.
  // This takes the skin as flat, which is enough for the slant; slab.glsl follows the ray more exactly.
  vec3 to_camera = normalize(frame.viewpoint.xyz - world_position);
  float facing = dot(to_camera, shading_normal);
  float rising = float(shell_side) * max(facing * float(shell_side), 0.2);  // the same sign over a whole triangle
  float up_speed = fur_length * cos(curve.z), across_speed = fur_length * sin(curve.z);
  vec3 crossing = (to_camera - facing * shading_normal) * (up_speed / rising) - across_speed * lean;
  vec3 tile_v = cross(shading_normal, tile_axis);
  vec2 sideways = vec2(dot(crossing, tile_axis), dot(crossing, tile_v));
  tile = tile_uv * frame.tile.x;
  float lateral = length(sideways) / nominal_length;
  // A leaning strand offers its length to a ray across the lean, which then crosses more strands.
  float aside = dot(cross(lean, to_camera), shading_normal) * across_speed / (rising * nominal_length);
  slant = sqrt(1.0 + lateral * lateral + aside * aside);
  float pixel = frame.viewpoint.w * distance(frame.viewpoint.xyz, world_position);
  level = clamp(log2(pixel / frame.tile.y) + 0.25 * log2(1.0 / max(abs(facing), 0.2)), 0.0, 7.0);
  density_share = weight * grown(groom.z);
  length_share = fur_length / nominal_length;
  tile_u = tile_axis;
  hand_on_paint();
  over = frame.colour_above[int(s * float(slice_count))].rgb;
  base_uv = image_uv;
  base_colour = colour;
  gl_Position = frame.world_to_clip * vec4(world_position, 1.0);
  vec4 speed = frame.world_to_clip * vec4(fur_length * fibre_tangent, 0.0);
  pixel_speed = frame.half_picture.xy * (speed.xy * gl_Position.w - gl_Position.xy * speed.w) /
                max(gl_Position.w * gl_Position.w, 1e-12);
  max_crossing = 5.0 * fur_length * frame.tile.x;
  gl_Position.z *= gl_Position.w / (gl_Position.w + push * fur_length / max(abs(facing), 0.2));  // depth is near / distance
  return s;
}
