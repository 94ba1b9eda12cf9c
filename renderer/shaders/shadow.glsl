// Shadows from maps: the transmittance of the shells above (GPU fur 3.1), and the shadow that one part of the body
// casts on another (GPU fur 4). Layout std140; renderer/upload/blocks.h mirrors it.
#include "constants.glsl"
layout(std140, binding = shadow_binding) uniform ShadowBlock {
  mat4 to_light[max_lights];
  vec4 axis[max_lights];   // linear depth: dot(xyz, position) + w, sizes
  vec4 slots[max_lights];  // slot of the shell maps (-1: none), slot of the depth map (-1: none), edge of the cast shadow
                           // (0 hard, 1 soft, 2 penumbra), its scale or the light's spread (-1: casts none)
} shadow;

layout(binding = shell_maps_unit) uniform sampler2DArray shell_maps;   // for each slot the 17 boundaries of shells, the skin first
layout(binding = depth_maps_unit) uniform sampler2DArray depth_maps;  // linear depth of the skin, or of the fur's hull (penumbra), sizes
layout(binding = width_maps_unit) uniform sampler2DArray width_maps;  // share of shadow nearby, which stands for the distance to its
                                                                      // edge; its mean times the caster's depth

const float own_part = 0.5 / float(slice_count);  // of the fur's height; nearer is the strand itself, which casts no shadow on itself
const float shadow_width = 0.03; // distance from a shadow's edge at which its map is white, sizes

const int search_taps = 8, penumbra_taps = 16;
const float penumbra_bias = 0.003;   // sizes
const float min_fold = 0.017;     // sizes; depth to which short fur may lie under the hull of long fur beside it
const float furthest_caster = 0.35;  // sizes; a penumbra does not get wider for casters further away

vec2 map_uv(int i, vec3 position) {
  vec4 clip = shadow.to_light[i] * vec4(position, 1.0);
  return vec2(0.5, -0.5) * (clip.xy / clip.w) + 0.5;
}

// Returns how far behind the depth map a position lies as seen from the light, sizes.
float depth_below(int i, vec3 position, vec2 at) {
  return dot(shadow.axis[i].xyz, position) + shadow.axis[i].w - texture(depth_maps, vec3(at, shadow.slots[i].y)).r;
}


// Returns the share of the light that gets past the body: AttenuShadow(sd, sw) = 1 - Cscale sw / sd below the lit skin
// (GPU fur 4). Where three bars cross, the map is white on both sides of a shadow's edge: under the first bar the
// second is dark, and beside it the third is. So white is weighted by how far its own caster lies in front of the
// position, over how far the caster in the depth map does.
float body_visibility(int i, vec3 position) {
  vec2 at = map_uv(i, position);
  float below = depth_below(i, position, at);
  if (below <= cast_bias) return 1.0;
  if (shadow.slots[i].z < 0.5) return 0.0;
  vec2 nearby = texture(width_maps, vec3(at, shadow.slots[i].y)).rg;
  float depth = dot(shadow.axis[i].xyz, position) + shadow.axis[i].w;
  float white = clamp((nearby.x * depth - nearby.y) / below, 0.0, nearby.x);  // 0.5 at the edge
  float width = shadow_width * max(2.0 * white - 1.0, 0.0);
  float fade = smoothstep(cast_bias, 3.0 * cast_bias, below);
  return 1.0 - fade * clamp(shadow.slots[i].w * width / below, 0.0, 1.0);
}

// The region of the depth map that is searched for occluders of a penumbra light, and the slope of the skin in it.
struct LightDisc {
  vec2 at;
  float depth;     // depth of the position, sizes
  float spread;    // half of the light's width over its distance
  float per_size;  // share of the map's side for a unit of length
  float texel;     // size of a texel, sizes
  vec2 slope;      // slope of the skin: depth over distance across the map
  float clearance;      // distance in front of the skin's plane within which nothing occludes
};

LightDisc light_disc(int i, vec3 position, vec3 normal, float clearance) {
  mat4 to_clip = shadow.to_light[i];
  vec4 clip = to_clip * vec4(position, 1.0);
  clip.w = max(clip.w, 1e-4);  // for positions that the light does not see
  vec3 right = vec3(to_clip[0].x, to_clip[1].x, to_clip[2].x), up = vec3(to_clip[0].y, to_clip[1].y, to_clip[2].y);
  float scale = length(right), facing = -dot(normal, shadow.axis[i].xyz), per_size = 0.5 * scale / clip.w;
  vec2 slope = facing > 0.0 ? vec2(dot(normal, right), dot(normal, up)) / (scale * max(facing, 0.2)) : vec2(0.0);
  return LightDisc(vec2(0.5, -0.5) * (clip.xy / clip.w) + 0.5, dot(shadow.axis[i].xyz, position) + shadow.axis[i].w,
                  shadow.slots[i].w / clip.w, per_size, 1.0 / (per_size * float(textureSize(depth_maps, 0).x)), slope, clearance);
}

// Samples the depth map at `taps` positions spread evenly over a disc. Returns the sum of the distances by which
// occluders lie in front of the skin's plane, and their count. A map's texel extends beyond its middle, so slopes need
// a larger bias.
vec2 blockers(int i, LightDisc disc, float radius, int taps) {
  const mat2 golden = mat2(-0.7373688, 0.6754903, -0.6754903, -0.7373688);  // 137.5 degrees
  float bias = disc.clearance + disc.texel * length(disc.slope);
  vec2 toward = vec2(1.0, 0.0), sum = vec2(0.0);
  for (int tap = 0; tap < taps; ++tap) {
    vec2 off = radius * sqrt((float(tap) + 0.5) / float(taps)) * toward;
    float seen = texture(depth_maps, vec3(disc.at + disc.per_size * vec2(off.x, -off.y), shadow.slots[i].y)).r;
    float before = disc.depth + dot(disc.slope, off) - seen;
    if (before > bias) sum += vec2(before, 1.0);
    toward = golden * toward;
  }
  return sum;
}

// Returns the share of the light that is visible past the body. Searches the map over an area as wide as the light
// appears at the occluders' distance (Fernando 2005). What lies in front by no more than the height of the fur does not
// count: it is fur into which the position grows, in folds.
float body_visibility_in_penumbra(int i, vec4 hull, vec3 normal) {
  LightDisc disc = light_disc(i, hull.xyz, normal, penumbra_bias + max(hull.w, min(10.0 * hull.w, min_fold)));
  float min_radius = 1.5 * disc.texel, max_radius = disc.spread * furthest_caster;
  vec2 found = blockers(i, disc, max(max_radius, min_radius), search_taps);
  float radius = clamp(disc.spread * found.x / max(found.y, 1.0), min_radius, max(max_radius, min_radius));
  int taps = found.y == 0.0 || found.y == float(search_taps) ? 0 : penumbra_taps;  // no more samples where all agree
  float hidden = taps == 0 ? found.y / float(search_taps) : blockers(i, disc, radius, taps).y / float(penumbra_taps);
  return 1.0 - hidden;
}

// Returns true for a light with a penumbra. Its depth map shows the fur's hull, that of other lights the skin.
bool is_penumbra(int i) { return shadow.slots[i].z > 1.5; }

// Returns the share of light i that gets past other parts of the body and guided curves, to skin of that normal or to
// fur on it. `hull`: position and height of the fur's hull.
float cast_visibility(int i, vec3 position, vec4 hull, vec3 normal) {
  if (shadow.slots[i].w < 0.0 || shadow.slots[i].y < 0.0) return 1.0;
  float transmitted = is_penumbra(i) ? body_visibility_in_penumbra(i, hull, normal) : body_visibility(i, position);
  return transmitted;
}

// Returns the optical depth of the shells above a position. Returns `estimate` where the map shows another part of the
// body, or where the surface is so oblique to the light that its shells leave no trace on the map. `facing` is N.L.
float shell_depth(int i, vec3 position, vec4 hull, float height, float facing, float estimate) {
  float slot = shadow.slots[i].x;
  if (slot < 0.0) return estimate;
  vec2 at = map_uv(i, position);
  const float shells = float(shadow_shells);
  float height_in_shells = min(height + own_part, 1.0) * shells, low = min(floor(height_in_shells), shells - 1.0);
  float first = slot * (shells + 1.0);
  float transmitted = mix(texture(shell_maps, vec3(at, first + low)).r,
                   texture(shell_maps, vec3(at, first + min(low + 1.0, shells))).r, height_in_shells - low);
  vec3 on_map = is_penumbra(i) ? hull.xyz : position;
  float below = depth_below(i, on_map, map_uv(i, on_map));
  return mix(-log(max(transmitted, 1e-3)), estimate, max(smoothstep(cast_bias, 2.0 * cast_bias, below), 1.0 - smoothstep(0.05, 0.35, facing)));
}
