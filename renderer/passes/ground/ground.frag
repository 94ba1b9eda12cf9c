#version 450 core
#include "frame.glsl"
#ifdef SHADOW_MAPS
#include "shadow.glsl"
#endif

in vec3 place;

uniform mat4 from_below;  // of the contact map
uniform float lowest;     // depth of the ground on the contact map, sizes
uniform float shadow_strength;
uniform float contact_strength;

layout(binding = contact_unit) uniform sampler2D contact_depth;  // depth of the skin seen from below, sizes

layout(location = 0) out vec4 result;

const int taps = 40;
const float contact_reach = 0.22;  // sizes

vec2 spiral(int i) {  // even over a disc
  float angle = 2.399963 * float(i);
  return sqrt((float(i) + 0.5) / float(taps)) * vec2(cos(angle), sin(angle));
}

// How much of the sky the model hides: a tap at distance r that has skin d above the ground hides 1 / (1 + (d / r)^2) of
// what comes from its side.
float contact() {
  float sum = 0.0, whole = 0.0;
  for (int i = 0; i < taps; ++i) {
    vec2 off = contact_reach * spiral(i) * length(spiral(i));
    float reach = max(length(off), 0.004);
    vec4 clip = from_below * vec4(place + vec3(off.x, 0.0, off.y), 1.0);
    float above = texture(contact_depth, vec2(0.5, -0.5) * clip.xy + 0.5).r - lowest;
    float weight = 1.0 - 0.6 * reach / contact_reach;
    sum += weight / (1.0 + above * above / (reach * reach + 0.0036));
    whole += weight;
  }
  return sum / whole;
}

#ifdef SHADOW_MAPS
// Share of light i that the body lets through: its shadow is softer the further it falls.
float past_body_softly(int i) {
  vec2 middle = place_on_map(i, place);
  float depth = dot(shadow.axis[i].xyz, place) + shadow.axis[i].w;
  float blocked = 0.0, blocker = 0.0;
  for (int i2 = 0; i2 < taps; ++i2) {
    float d = texture(depth_maps, vec3(middle + 0.05 * spiral(i2), shadow.slots[i].y)).r;
    if (d < depth - cast_bias) blocked += 1.0, blocker += d;
  }
  if (blocked == 0.0) return 1.0;
  float before = depth - blocker / blocked, radius = clamp(0.09 * before, 0.004, 0.05);
  if (shadow.slots[i].z < 0.5) radius = 0.0;
  LightDisc disc = light_disc(i, place, vec3(0.0, 1.0, 0.0), penumbra_bias);
  if (shadow.slots[i].z > 1.5) radius = disc.spread * disc.per_size * before;
  float sum = 0.0;
  for (int i2 = 0; i2 < taps; ++i2) {
    vec2 at = middle + radius * spiral(i2);
    bool beside = any(lessThan(at, vec2(0.0))) || any(greaterThan(at, vec2(1.0)));
    sum += beside || texture(depth_maps, vec3(at, shadow.slots[i].y)).r >= depth - cast_bias ? 1.0 : 0.0;
  }
  return sum / float(taps);
}

float light_here(int i) {
  float kept = past_body_softly(i);
#ifdef CURVE_SHADOWS
  kept *= past_curves(i, place);
#endif
  return kept;
}
#endif

// The share of light that is missing darkens what lies behind: premultiplied black.
void main() {
  float ambient = frame.weights.x;
  float hidden = contact_strength * contact();
  float whole = ambient, here = ambient * (1.0 - hidden);
  for (int i = 0; i < int(frame.counts.z); ++i) {
    Light light = frame.lights[i];
    vec3 apart = light.position.xyz - place;
    float square = max(dot(apart, apart), 1e-6);
    bool near = light.direction.w > 0.5;
    float facing = max(near ? apart.y * inversesqrt(square) : -light.direction.y, 0.0);
    float inside = near ? -dot(apart, light.direction.xyz) * inversesqrt(square) : 1.0, edge = light.position.w;
    facing *= clamp((inside - edge) / max(light.radiance.w - edge, 1e-6), 0.0, 1.0);  // in a spot's cone
    float arrives = frame.weights.y * facing * luminance(light.radiance.rgb) * (near ? min(1.0 / square, 1e6) : 1.0);
    whole += arrives;
#ifdef SHADOW_MAPS
    bool mapped = shadow.slots[i].w >= 0.0 && shadow.slots[i].y >= 0.0;
    if (mapped) arrives *= mix(1.0, light_here(i), shadow_strength);
#else
    const bool mapped = false;
#endif
    here += mapped ? arrives : arrives * (1.0 - hidden);  // a light without a map counts as wide
  }
  float edge = 1.0 - smoothstep(1.0, 3.5, length(place.xz));
  result = vec4(0.0, 0.0, 0.0, clamp(1.0 - here / max(whole, 1e-6), 0.0, 1.0) * edge);
}
