#version 450 core
// An eye, ray traced inside its box: a ball, a bulging cornea, an iris behind it and lids in front (docs/eyes.md).
#include "frame.glsl"
#include "lighting.glsl"
#include "eye_block.glsl"
#ifdef AOVS
#include "aovs.glsl"
#endif

// x^p for x in [0, 1] as an exponential of a logarithm that stays finite.
float power(float x, float p) { return exp2(p * log2(max(x, 1e-12))); }

layout(binding = tissues_unit) uniform sampler2DArray tissues;   // renderer/eye/iris_map.h
layout(binding = caustics_unit) uniform sampler2DArray caustics;  // renderer/eye/optics.h

uniform int steps;

in vec3 local;
flat in vec3 viewer;
flat in int number;

layout(location = 0) out vec4 result;  // premultiplied

const float rows = float(iris_map_height);
const float max_value = 6e4;             // half floats end at 65504
const float forward_scatter = 0.2;  // Henyey and Greenstein's g

Eye eye;
float pixel;  // its size at the eye, radii
int light_count;    // that light it

vec3 in_frame(vec3 v) { return vec3(dot(eye.right.xyz, v), dot(eye.up.xyz, v), dot(eye.forward.xyz, v)); }
vec3 in_world(vec3 v) { return eye.right.xyz * v.x + eye.up.xyz * v.y + eye.forward.xyz * v.z; }
vec3 unit(vec3 v) { return v * inversesqrt(max(dot(v, v), 1e-12)); }

// The angle to the edge of the lids, above 0 where they are open.
float opening(vec3 direction) {
  if (eye.lid_right.w == 0.0) return 10.0;
  vec3 d = vec3(dot(eye.lid_right.xyz, direction), dot(eye.lid_up.xyz, direction), dot(eye.lid_facing.xyz, direction));
  float x = atan(d.x, d.z) / eye.lid_right.w, y = atan(d.y, length(d.xz));
  float narrowing = 1.0 - x * x;
  float upper = eye.lid_up.w * narrowing - y, lower = y + eye.lid_facing.w * narrowing;
  return min(upper, lower);
}

// Share of the light from a direction that the lids let through to a place under them.
float past_lids(vec3 place, vec3 to_light) {
  float along = dot(place, to_light), apart = lid_radius * lid_radius - dot(place, place);
  if (eye.lid_right.w == 0.0 || apart <= 0.0) return 1.0;
  float path = sqrt(along * along + apart) - along;
  return smoothstep(-0.10, 0.12, opening(unit(place + path * to_light)));
}

float open_sky(vec3 place) { return mix(0.22, 1.0, smoothstep(-0.05, 0.55, opening(unit(place)))); }

// Unpolarised Fresnel reflectance, as in renderer/eye/optics.cpp.
float reflectance(float cosine, float index) {
  float c = clamp(cosine, 0.0, 1.0), inside = sqrt(index * index - 1.0 + c * c);
  if (inside + c <= 1e-6) return 0.0;
  float across = (c - inside) / (c + inside), along = (index * index * c - inside) / (index * index * c + inside);
  return 0.5 * (across * across + along * along);
}

// Into an index of 1 or more light always goes; with the wrong ratio refract() would answer a zero vector.
vec3 refracted(vec3 along, vec3 normal) {
  float eta = 1.0 / eye.position.w, cosine = clamp(-dot(along, normal), 0.0, 1.0);
  return eta * along + (eta * cosine - sqrt(max(1.0 - eta * eta * (1.0 - cosine * cosine), 0.0))) * normal;
}

struct Lit {
  vec3 to_light, radiance;
};

Lit lit_by(int i, vec3 place) {
  Lit lit;
  vec3 to_light;
  light_at(i, eye.position.xyz + eye.right.w * in_world(place), to_light, lit.radiance);
  lit.to_light = in_frame(to_light);
  return lit;
}

// Irradiance on the iris at a place, over that of a surface which faces the light.
float gathered(vec2 at, vec3 to_light) {
  float angle = acos(clamp(to_light.z, -1.0, 1.0)) * float(caustic_angles - 1) / caustic_reach;
  if (angle >= float(caustic_angles - 1)) return 0.0;
  vec2 from = to_light.xy * inversesqrt(max(dot(to_light.xy, to_light.xy), 1e-12));
  vec2 turned = vec2(dot(at, from), from.x * at.y - from.y * at.x) / eye.up.w * 0.5 + 0.5;
  float index = floor(angle), first = eye.pupil.w + index;
  return mix(textureLod(caustics, vec3(turned, first), 0.0).r, textureLod(caustics, vec3(turned, first + 1.0), 0.0).r,
             angle - index);
}

// Distance from the axis to the pupil's edge in the direction of a place on the iris.
float pupil_edge(vec2 at) {
  vec2 axes = max(eye.pupil.xy * eye.up.w, vec2(1e-4));
  vec2 way = at * inversesqrt(max(dot(at, at), 1e-12));
  if (eye.pupil.z < 0.5) return axes.x;
  float a = abs(way.x) / axes.x, b = way.y * way.y / (axes.y * axes.y);
  float almond = 2.0 / (a + sqrt(a * a + 4.0 * b));  // |x| / w + (y / h)^2 = 1
  return 0.5 * (almond + inversesqrt(a * a + b));    // half way to an ellipse
}

vec4 tissue_at(vec2 at, float edge) {
  float room = max(eye.up.w - edge, 0.02);
  float along = clamp((length(at) - edge) / room, 0.0, 1.0);
  float around = atan(at.y, at.x) * 0.15915494 + eye.inner.w;
  return textureLod(tissues, vec3(around, along, 0.0), max(log2(pixel * rows / room), 0.0));
}

// Light that the tissue sends back, with Henyey and Greenstein's phase over its value for light that turns round.
float phase(float cosine) {
  float g = forward_scatter, turned = 1.0 + g;
  return pow(turned * turned / (1.0 + g * g - 2.0 * g * cosine), 1.5);
}

struct IrisLight {
  vec3 arriving[max_lights];  // irradiance on the iris
  float rising[max_lights];   // cosine of the light inside
  float scattered[max_lights];
};

IrisLight light_on_iris(vec3 surface, vec3 normal, vec3 inside, vec2 at) {
  IrisLight lights;
  for (int i = 0; i < light_count; ++i) {
    Lit lit = lit_by(i, surface);
    lights.arriving[i] = lit.radiance * gathered(at, lit.to_light) * past_lids(surface, lit.to_light);
    vec3 way = refracted(-lit.to_light, dot(lit.to_light, normal) > 0.0 ? normal : lit.to_light);
    lights.rising[i] = max(-way.z, 0.15);
    lights.scattered[i] = phase(dot(way, -inside));
  }
  return lights;
}

vec3 tint(vec4 tissue) { return mix(eye.iris.rgb, eye.inner.rgb, tissue.b); }

// A flat or once shifted iris: all of its light comes from one place.
vec3 flat_iris(vec2 at, IrisLight lights, float sky) {
  vec4 tissue = tissue_at(at, pupil_edge(at));
  vec3 sum = vec3(frame.weights.x * sky);
  for (int i = 0; i < light_count; ++i) sum += lights.arriving[i];
  return sum * tint(tissue) * tissue.r * 1.5;
}

// What a step through tissue sends back of the light that falls on it, over what thick tissue does: scattered once,
// with the light's way in from above the step and through it, and the ray's way through it. Steps of any size add up to 1.
float sent_back(float above, float thick, float slant, float rising) {
  return exp(-above / rising) * (1.0 - exp(-thick * (slant + 1.0 / rising)));
}

// Subsurface texture mapping (character rendering; Francois et al. 2006): ray marching through the iris.
// Height says where tissue is; it scatters once, and what lies deeper is darker and more saturated. Below it is the pigment.
vec3 marched_iris(vec2 top, vec2 bottom, float slant, IrisLight lights, float sky) {
  const float density = 7.0;  // optical depth of the whole relief
  vec3 sum = vec3(0.0);
  float passed = 1.0;
  float share = 1.0 / float(steps);
  vec4 tissue = vec4(0.0);
  for (int k = 0; k < steps && passed > 0.02; ++k) {
    float depth = (float(k) + 0.5) * share;
    vec2 at = mix(top, bottom, depth);
    float edge = pupil_edge(at);
    tissue = tissue_at(at, edge);
    float below = tissue.g - (1.0 - depth);
    float thick = density * min(max(below + 0.5 * share, 0.0), share);  // of the tissue inside this step
    float there = smoothstep(-pixel, pixel, length(at) - edge);
    if (thick * there <= 0.0) continue;
    float above = density * max(below - 0.5 * share, 0.0);
    vec3 colour = tint(tissue);
    vec3 light = frame.weights.x * sky * vec3(sent_back(above, thick, slant, 2.0));
    for (int i = 0; i < light_count; ++i) {
      light += lights.arriving[i] * (lights.scattered[i] * sent_back(above, thick, slant, lights.rising[i]));
    }
    sum += passed * there * light * mix(colour, colour * colour, clamp(below, 0.0, 1.0)) * tissue.r * 1.5;
    passed *= 1.0 - there * (1.0 - exp(-thick * slant));
  }
  float edge = pupil_edge(bottom);
  vec3 pigment = eye.iris.rgb * eye.iris.rgb * smoothstep(-pixel, pixel, length(bottom) - edge);
  vec3 light = vec3(frame.weights.x * sky);
  for (int i = 0; i < light_count; ++i) light += lights.arriving[i];
  return sum + passed * 0.25 * light * pigment;
}

// Where a ray goes on behind the cornea.
vec3 through_cornea(vec3 normal, vec3 along) {
  return steps == 0 ? vec3(0.0, 0.0, -1.0) : refracted(along, normal);
}

vec2 place_on_iris(vec3 place, vec3 inside) {
  return place.xy + inside.xy * (max(place.z - eye.cornea.z, 0.0) / max(-inside.z, 0.05));
}

// What is seen through the cornea at a place on it.
vec3 iris_light(vec3 place, vec3 normal, vec3 along) {
  vec3 inside = through_cornea(normal, along);
  float falling = max(-inside.z, 0.05);
  vec2 bottom = place_on_iris(place, inside);
  vec2 top = bottom - inside.xy * (eye.cornea.w / falling);
  float reach = length(bottom);
  if (steps == 0 || reach > eye.up.w) bottom *= min(1.0, eye.up.w / max(reach, 1e-6));
  float wall = steps == 0 ? 0.0 : smoothstep(0.97, 1.04, reach / eye.up.w);  // the side of the chamber
  float sky = open_sky(place);
  IrisLight lights = light_on_iris(place, normal, inside, bottom);
  vec3 seen;
  if (steps <= 1) {
    seen = flat_iris(bottom, lights, sky);
    float edge = pupil_edge(bottom), soft = max(pixel, 0.01);
    seen *= smoothstep(-soft, soft, length(bottom) - edge);
  } else {
    seen = marched_iris(top, bottom, 1.0 / falling, lights, sky);
  }
  float ring = eye.iris.w * smoothstep(0.72, 0.98, length(bottom) / eye.up.w);
  return mix(seen * (1.0 - 0.92 * ring), eye.iris.rgb * 0.03 * sky, wall);
}

// The white: vessels redden it away from the iris, and light wraps around it, red the furthest.
vec3 sclera_colour(vec3 place) {
  float back = acos(clamp(place.z, -1.0, 1.0)) - asin(clamp(eye.up.w, 0.0, 1.0));
  vec2 at = vec2(atan(place.y, place.x) * 0.15915494 + eye.inner.w, clamp(back / 1.2, 0.0, 1.0));
  vec4 tissue = textureLod(tissues, vec3(at, 0.0), max(log2(pixel * rows / 1.2), 0.0));
  float lid = 1.0 - smoothstep(0.0, 0.45, opening(unit(place)));
  float red = clamp(0.75 * lid + 0.5 * smoothstep(0.15, 1.0, back), 0.0, 1.0);
  vec3 colour = eye.sclera.rgb * mix(vec3(1.0), vec3(0.80, 0.42, 0.36), 0.6 * red);
  colour *= mix(vec3(1.0), vec3(0.72, 0.25, 0.20), 0.65 * tissue.a * (0.35 + 0.65 * red));
  return colour * (1.0 - 0.9 * eye.iris.w * (1.0 - smoothstep(0.0, 0.16, back)));
}

vec3 sclera_light(vec3 place, vec3 normal) {
  const vec3 wrap = vec3(0.45, 0.28, 0.22);
  vec3 sum = vec3(frame.weights.x * open_sky(place));
  for (int i = 0; i < light_count; ++i) {
    Lit lit = lit_by(i, place);
    vec3 wrapped = max((dot(normal, lit.to_light) + wrap) / (1.0 + wrap), 0.0);
    sum += lit.radiance * wrapped * past_lids(place, lit.to_light);
  }
  return sclera_colour(place) * sum;
}

// What the head's surroundings send along a reflected ray: a soft sky, a darker ground, and fur beside the eye.
vec3 surroundings_along(vec3 way, vec3 place) {
  float height = eye.right.y * way.x + eye.up.y * way.y + eye.forward.y * way.z;
  vec3 light = surroundings.rgb * mix(0.30, 1.15, smoothstep(-0.25, 0.75, height));
  vec3 facing = eye.lid_right.w == 0.0 ? vec3(0.0, 0.0, 1.0) : eye.lid_facing.xyz;
  return light * mix(0.08, 1.0, smoothstep(-0.15, 0.55, dot(way, facing))) * past_lids(place, way);
}

// The tear film: every light is a soft disc whose size wetness sets; its energy stays.
vec3 reflected_light(vec3 place, vec3 normal, vec3 along) {
  float mirrored = reflectance(-dot(along, normal), eye.position.w);
  vec3 way = along - 2.0 * min(dot(along, normal), 0.0) * normal;
  float disc = mix(0.5, 0.11, eye.sclera.w);  // radians
  float gain = 1.0 / (sin(disc) * sin(disc));
  vec3 sum = surroundings_along(way, place);
  for (int i = 0; i < light_count; ++i) {
    Lit lit = lit_by(i, place);
    float off = acos(clamp(dot(way, lit.to_light), -1.0, 1.0));
    sum += lit.radiance * gain * (1.0 - smoothstep(0.85 * disc, 1.15 * disc, off)) * past_lids(place, lit.to_light);
  }
  return mirrored * mix(0.35, 1.0, eye.sclera.w) * sum;
}

float lid_margin(vec3 place) { return 1.0 - smoothstep(0.02, 0.14, -opening(unit(place))); }  // moist along the edge
vec3 lid_colour(vec3 place) { return mix(eye.lid.rgb, eye.lid.rgb * vec3(0.7, 0.55, 0.55), lid_margin(place)); }

vec3 lid_light(vec3 place, vec3 along) {
  vec3 normal = unit(place), colour = lid_colour(place);
  float margin = lid_margin(place);
  vec3 sum = frame.weights.x * colour;
  for (int i = 0; i < light_count; ++i) {
    Lit lit = lit_by(i, place);
    vec3 middle = unit(lit.to_light - along);
    float facing = max(dot(normal, lit.to_light), 0.0);
    float gloss = mix(0.03, 0.25, margin) * power(max(dot(normal, middle), 0.0), mix(10.0, 40.0, margin));
    sum += lit.radiance * facing * (colour + gloss);
  }
  return sum;
}

struct Surface {
  vec3 place;
  float covered;  // share of the pixel, softened over one pixel
};

// Where the ray enters a ball on the axis. Taken from the ray's nearest place to its centre, so that nothing is lost
// far from the eye; where it misses by less than a pixel, the place on the silhouette.
Surface enter(vec3 along, float centre, float radius) {
  vec3 off = local - vec3(0.0, 0.0, centre);
  vec3 nearest = off - along * dot(off, along);
  float square = dot(nearest, nearest), inner = radius * radius - square;
  Surface surface;
  surface.place = inner > 0.0 ? nearest - along * sqrt(inner) : nearest * (radius * inversesqrt(max(square, 1e-12)));
  surface.place.z += centre;
  surface.covered = clamp((radius - sqrt(square)) / pixel + 0.5, 0.0, 1.0);
  return surface;
}

// 1 on the cornea, 0 on the white.
float cornea_share(vec3 place) {
  float soft = max(0.04 * eye.up.w, pixel);
  return place.z > 0.0 ? 1.0 - smoothstep(eye.up.w - soft, eye.up.w + soft, length(place.xy)) : 0.0;
}

// Of ball and cornea; it never turns away from the ray.
vec3 eyeball_normal(vec3 place, vec3 along) {
  vec3 bulged = unit(place - vec3(0.0, 0.0, eye.cornea.x));
  vec3 normal = unit(mix(unit(place), bulged, cornea_share(place)));
  return dot(normal, along) > -1e-3 ? unit(normal - along * (dot(normal, along) + 1e-3)) : normal;
}

vec3 eyeball_light(vec3 place, vec3 along) {
  float cornea = cornea_share(place);
  vec3 normal = eyeball_normal(place, along);
  vec3 seen = cornea < 1.0 ? sclera_light(place, normal) : vec3(0.0);
  if (cornea > 0.0) seen = mix(seen, iris_light(place, normal, along), cornea);
  float kept = 1.0 - reflectance(-dot(along, normal), eye.position.w);
  float shaded = mix(0.30, 1.0, smoothstep(0.0, 0.30, opening(unit(place))));  // by lids and lashes close by
  return shaded * (seen * kept + reflected_light(place, normal, along));
}

struct Seen {
  vec3 ball, lid;       // places
  float open, covered;  // share of the ball that is seen, share of the pixel
  float shut;           // share of that which lids hide
};

vec3 light_of(Seen seen, vec3 along) {
  vec3 light = vec3(0.0);
  if (seen.shut < 1.0 && seen.open > 0.0) light = eyeball_light(seen.ball, along);
  return seen.shut > 0.0 ? mix(light, lid_light(seen.lid, along), seen.shut) : light;
}

#ifdef AOVS
vec3 albedo_of(Seen seen, vec3 along) {
  vec2 at = place_on_iris(seen.ball, through_cornea(eyeball_normal(seen.ball, along), along));
  vec4 tissue = tissue_at(at, pupil_edge(at));
  float there = smoothstep(-pixel, pixel, length(at) - pupil_edge(at));
  vec3 ball = mix(sclera_colour(seen.ball), there * tint(tissue) * tissue.r, cornea_share(seen.ball));
  return mix(ball, lid_colour(seen.lid), seen.shut);
}

// Lids and cornea count as what reflects, not as shadow: all of the lights' share is left.
void write_eye_aovs(Seen seen, vec3 along, vec3 hit, vec3 light) {
  light_count = 0;
  direct_light = clamp(light - light_of(seen, along), 0.0, max_value);
  light_share = vec2(luminance(direct_light));
  vec3 normal = seen.shut > 0.5 ? unit(seen.lid) : eyeball_normal(seen.ball, along);
  write_aovs(eye.position.xyz + eye.right.w * in_world(hit), in_world(normal), vec3(0.0), albedo_of(seen, along), 0.0,
               seen.covered);
}
#endif

void main() {
  eye = eyes[number];
  light_count = int(frame.counts.z);
  vec3 along = unit(local - viewer);
  pixel = max(frame.viewpoint.w * distance(local, viewer), 1e-6);
  Surface ball = enter(along, 0.0, 1.0), dome = enter(along, eye.cornea.x, eye.cornea.y);
  bool over = dome.covered > 0.0 && (ball.covered <= 0.0 || dot(dome.place - ball.place, along) < 0.0);
  Surface lid = enter(along, 0.0, lid_radius);
  Seen seen;
  seen.ball = over ? dome.place : ball.place, seen.lid = lid.place;
  seen.open = max(ball.covered, dome.covered);
  seen.shut = eye.lid_right.w == 0.0 || length(viewer) <= lid_radius ? 0.0
              : 1.0 - smoothstep(-0.5 * pixel, 0.5 * pixel, opening(unit(lid.place)));
  seen.covered = mix(seen.open, lid.covered, seen.shut);
  if (seen.covered <= 0.0) discard;
  vec3 hit = seen.shut > 0.5 ? seen.lid : seen.ball;
  if (dot(hit - viewer, along) <= 0.0) discard;  // behind the camera, or around it
  vec4 clip = frame.world_to_clip * vec4(eye.position.xyz + eye.right.w * in_world(hit), 1.0);
  gl_FragDepth = clamp(clip.z / max(clip.w, 1e-12), 0.0, 1.0);
#ifdef COVERING
  if (seen.covered < 0.5) discard;
  result = vec4(1.0 / max(clip.w, 1e-12), 0.0, 0.0, 1.0);
#else
  vec3 light = clamp(light_of(seen, along), 0.0, max_value);  // mixing with a blinding light may end below 0
  result = vec4(light * seen.covered, seen.covered);
#ifdef AOVS
  write_eye_aovs(seen, along, hit, light);
#endif
#endif
}
