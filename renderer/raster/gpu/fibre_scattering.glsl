// The fibre shading models, with the azimuthal part from the same fit as on the CPU (renderer/optics/azimuthal_fit.h).
#include "../../shaders/scattering_block.glsl"

layout(std430, binding = azimuthal_storage) readonly buffer AzimuthalFit {
  uint azimuths, inclinations;
  uint azimuthal_words[];  // five for each node
};

float lower_bfloat(uint word) { return uintBitsToFloat(word << 16); }
float upper_bfloat(uint word) { return uintBitsToFloat(word & 0xffff0000u); }

// Adds a weighted node to the coefficients of a cubic polynomial in the absorption; curve.x is the constant term.
// `along`: longitudinal factors of R, TT, TRT and the rest.
void add_node(uint node, float weight, vec4 along, inout vec4 curve) {
  uint at = 5 * node, word[5];
  for (uint k = 0; k < 5; ++k) word[k] = azimuthal_words[at + k];
  vec4 w = weight * along;
  curve.x += w.x * lower_bfloat(word[0]);
  curve.y += w.y * upper_bfloat(word[0]) + w.z * lower_bfloat(word[2]) + w.w * upper_bfloat(word[3]);
  curve.z += w.y * lower_bfloat(word[1]) + w.z * upper_bfloat(word[2]) + w.w * lower_bfloat(word[4]);
  curve.w += w.y * upper_bfloat(word[1]) + w.z * lower_bfloat(word[3]) + w.w * upper_bfloat(word[4]);
}

vec3 azimuthal_light(vec4 along, float azimuth, float cos_theta, vec3 absorption) {
  vec2 at = clamp(vec2(azimuth, cos_theta), 0.0, 1.0) * vec2(azimuths - 1, inclinations - 1);
  uvec2 low = uvec2(min(floor(at), vec2(azimuths - 2, inclinations - 2)));
  vec2 share = at - vec2(low);
  vec4 curve = vec4(0.0);
  for (uint k = 0; k < 4; ++k) {
    uvec2 off = uvec2(k & 1u, k >> 1);
    vec2 part = mix(1.0 - share, share, vec2(off));
    add_node((low.y + off.y) * azimuths + low.x + off.x, part.x * part.y, along, curve);
  }
  vec3 t = absorption;
  return max(((curve.w * t + curve.z) * t + curve.y) * t + curve.x, 0.0);
}

#include "../../shaders/shared/scattering.glsl"
