// Bare skin: regions with a look of their own (protocol/commands/creature.h). After frame.glsl and lighting.glsl. Layout
// std140; renderer/upload/blocks.h mirrors it. renderer/skin has the shapes in double, for the length of the fur.
#include "constants.glsl"
struct SkinRegion {
  vec4 across, up, along;  // rows to the unit ball; w: softness, 1 / least radius, cosine of whole facing
  vec4 centre;             // w: scatter
  vec4 facing;             // w: cosine of no facing
  vec4 colour;             // w: shine
  vec4 finish;             // roughness, wetness, height and size of the bumps
};

layout(std140, binding = skin_binding) uniform SkinBlock {
  uvec4 count;
  vec4 balls[max_skin_regions];          // around all that a region colours: centre, square of the radius
  SkinRegion regions[max_skin_regions];
} bare_skin;

struct Bare {
  vec4 colour;   // w: shine
  vec4 finish;
  float scatter;
  float share;   // of what is seen here that is bare
};

// The colour ends where fur has about half of its length, or within two pixels where that is sharper, and within twice the
// region's radii where that is smaller than pixels.
float bare_share(SkinRegion region, vec3 place, vec3 normal, float pixel) {
  vec3 apart = place - region.centre.xyz;
  float off = length(vec3(dot(region.across.xyz, apart), dot(region.up.xyz, apart), dot(region.along.xyz, apart)));
  float edge = max(0.5 * region.across.w, min(2.0 * pixel * region.up.w + 1e-6, 1.0));
  return (1.0 - smoothstep(1.0, 1.0 + edge, off)) *
         smoothstep(region.facing.w, region.along.w, dot(normal, region.facing.xyz));
}

const Bare not_bare = Bare(vec4(0.0), vec4(0.0), 0.0, 0.0);

// Skin that is painted bare: of the scene's colour, otherwise as protocol/commands/creature.h has it. It ends where fur has
// about half of its length.
Bare painted_bare(vec3 colour, float bare, float wetness) {
  return Bare(vec4(colour, 0.5), vec4(0.5, wetness, 0.0004, 0.004), 0.5, smoothstep(0.3, 0.7, bare));
}

// All regions at a place, each over those before it and over what is bare without them.
Bare bare_over(Bare bare, vec3 place, vec3 normal) {
  float pixel = frame.viewpoint.w * distance(frame.viewpoint.xyz, place);
  for (uint i = 0u; i < bare_skin.count.x; ++i) {
    vec3 apart = place - bare_skin.balls[i].xyz;
    if (dot(apart, apart) > bare_skin.balls[i].w) continue;  // so that most of the body costs little
    SkinRegion region = bare_skin.regions[i];
    float share = bare_share(region, place, normal, pixel);
    if (share <= 0.0) continue;
    bare.share = 1.0 - (1.0 - bare.share) * (1.0 - share);
    float over = share / bare.share;
    bare.colour = mix(bare.colour, region.colour, over);
    bare.finish.xyz = mix(bare.finish.xyz, region.finish.xyz, over);
    bare.finish.w = over >= 0.5 ? region.finish.w : bare.finish.w;
    bare.scatter = mix(bare.scatter, region.centre.w, over);
  }
  return bare;
}

vec3 point_in_cell(ivec3 cell) {  // pcg3d (Jarzynski and Olano 2020)
  uvec3 v = uvec3(cell) * 1664525u + 1013904223u;
  v.x += v.y * v.z, v.y += v.z * v.x, v.z += v.x * v.y;
  v ^= v >> 16u;
  v.x += v.y * v.z, v.y += v.z * v.x, v.z += v.x * v.y;
  return vec3(v >> 8u) / 16777216.0;
}

// Leather of domed cells with creases between them, where the two nearest points are as near (Worley 1996). Slope in
// xyz, in cells; in w how far the crease is left behind, 0 at its bottom.
vec4 leather(vec3 at) {
  ivec3 middle = ivec3(floor(at));
  vec3 first = vec3(9.0), second = vec3(9.0);
  for (int k = 0; k < 27; ++k) {
    ivec3 cell = middle + ivec3(k % 3, k / 3 % 3, k / 9) - 1;
    vec3 apart = at - vec3(cell) - point_in_cell(cell);
    if (dot(apart, apart) < dot(first, first)) {
      second = first, first = apart;
    } else if (dot(apart, apart) < dot(second, second)) {
      second = apart;
    }
  }
  const float crease = 0.55;
  float x = clamp((length(second) - length(first)) / crease, 0.0, 1.0);
  vec3 away = second / max(length(second), 1e-6) - first / max(length(first), 1e-6);
  return vec4(away * (6.0 * x * (1.0 - x) / crease) - 2.0 * first, x * x * (3.0 - 2.0 * x));
}

// Blinn's highlight, its energy the same at any width, and Schlick's reflectance. A light is not a point, so that no
// highlight is narrower than that of roughness 0.15.
float highlight(vec3 normal, vec3 to_light, vec3 to_camera, float f0, float roughness) {
  vec3 between = to_light + to_camera;
  between *= inversesqrt(max(dot(between, between), 1e-12));
  float alpha = max(roughness, 0.15) * max(roughness, 0.15), exponent = 2.0 / (alpha * alpha) - 2.0;
  float fresnel = f0 + (1.0 - f0) * pow(1.0 - clamp(dot(between, to_camera), 0.0, 1.0), 5.0);
  float lobe = (exponent + 8.0) / 8.0 * pow(max(dot(normal, between), 1e-6), exponent);
  return fresnel * lobe * max(dot(normal, to_light), 0.0);
}

// What the surroundings send along a mirrored ray: a soft sky over a darker ground.
vec3 mirrored_sky(vec3 normal, vec3 to_camera, float f0, float roughness) {
  float facing = max(dot(normal, to_camera), 0.0);
  vec3 way = 2.0 * facing * normal - to_camera;
  float spread = mix(0.25, 1.5, roughness);
  float sky = mix(0.25, 1.15, smoothstep(-spread, spread, way.y));
  float mirrored = f0 + max(1.0 - roughness - f0, 0.0) * pow(1.0 - facing, 5.0);
  return frame.weights.x * environment_light(way) * sky * mirrored;
}

const float film_roughness = 0.28;  // of the wet film: glints, not sparks

struct SkinPoint {
  vec3 place, to_camera, normal, film;  // normals of the relief, and of the wet film that partly fills it
  vec3 colour;
  float open;                        // 0 in the depth of a crease
  float dry_roughness, wet_roughness;
};

SkinPoint skin_point(Bare bare, vec3 place, vec3 normal) {
  vec3 to_camera = normalize(frame.viewpoint.xyz - place);
  float size = max(bare.finish.w, 1e-4), pixel = frame.viewpoint.w * distance(frame.viewpoint.xyz, place);
  float seen = smoothstep(3.0, 8.0, size / max(pixel, 1e-9));  // cells of a pixel would sparkle: they widen highlights
  float whole = min(bare.finish.z / size, 4.0), steep = seen * whole;
  vec4 relief = steep > 0.0 ? leather(place / size) : vec4(0.0, 0.0, 0.0, 1.0);
  vec3 slope = relief.xyz - dot(relief.xyz, normal) * normal;
  vec3 bumped = normalize(normal - steep * slope);
  float open = mix(1.0, relief.w, min(2.0 * steep, 0.6));
  vec3 colour = bare.colour.rgb * (1.0 - 0.4 * bare.finish.y);
  float uneven = 1.0 - 0.7 * bare.finish.y, lost = whole - steep;
  return SkinPoint(place, to_camera, bumped, normalize(normal - uneven * steep * slope), colour, open,
                   min(bare.finish.x + lost, 1.0), min(film_roughness + uneven * lost, 1.0));
}

vec3 light_on_skin(Bare bare, SkinPoint point, vec3 to_light) {
  vec3 wrap = bare.scatter * vec3(0.45, 0.20, 0.14);
  vec3 wrapped = max((dot(point.normal, to_light) + wrap) / (1.0 + wrap), 0.0);
  vec3 diffuse = frame.weights.y * point.open * point.colour * wrapped;
  float skin = highlight(point.normal, to_light, point.to_camera, 0.08 * bare.colour.w, point.dry_roughness);
  float film = highlight(point.film, to_light, point.to_camera, 0.03, point.wet_roughness);
  return diffuse + point.open * mix(bare.colour.w > 0.0 ? skin : 0.0, film, bare.finish.y);
}

// Light that bare skin sends to the camera; `open` as in a Fibre: the hull of fur that is bared here or stands around it does not
// shade it.
vec3 bare_light(Bare bare, vec3 place, vec4 open, vec3 normal) {
  SkinPoint point = skin_point(bare, place, normal);
  vec3 sum = frame.weights.x * point.open * point.colour * environment_light(point.normal);
  vec3 dry = vec3(0.0);
  if (bare.colour.w > 0.0) dry = mirrored_sky(point.normal, point.to_camera, 0.08 * bare.colour.w, point.dry_roughness);
  sum += point.open * mix(dry, mirrored_sky(point.film, point.to_camera, 0.03, point.wet_roughness), bare.finish.y);
  for (int i = 0; i < LIGHTS; ++i) {
    vec3 to_light, radiance;
    light_at(i, place, to_light, radiance);
    vec3 sent = light_on_skin(bare, point, to_light), kept = radiance * sent;
#ifdef SHADOW_MAPS
    kept *= cast_light(i, place, open, normal);
#endif
    sum += kept;
  }
  return sum;
}
