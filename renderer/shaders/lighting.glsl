// GPU fur eq 1: c = ka g + [kd C (1-(T.L)^2)^(pd/2) + ks (1-(T.H)^2)^(ps/2)] t B, for each light.

#ifdef SHADOW_MAPS
#include "shadow.glsl"
#endif

// x^p for x in [0, 1] as an exponential of a logarithm that stays finite.
float power(float x, float p) { return exp2(p * log2(max(x, 1e-12))); }

// Where the light comes from, unit, and what arrives at the place.
void light_at(int i, vec3 place, out vec3 to_light, out vec3 radiance) {
  Light light = frame.lights[i];
  vec3 apart = light.position.xyz - place;
  float square = max(dot(apart, apart), 1e-8);
  bool point = light.direction.w > 0.5;
  to_light = point ? apart * inversesqrt(square) : -light.direction.xyz;
  radiance = light.radiance.rgb * (point ? min(1.0 / square, 1e8) : 1.0);
  float inside = dot(-to_light, light.direction.xyz), edge = light.position.w;
  radiance *= clamp((inside - edge) / max(light.radiance.w - edge, 1e-6), 0.0, 1.0);
}

// Light that passes pale fur keeps its colour and much of its strength: t_c = t^(1 - f_c) (science.md 4).
vec3 transmittance(float depth, vec3 colour) { return exp2(-1.442695 * depth * (1.0 - 0.82 * sqrt(clamp(colour, 0.0, 1.0)))); }

// Light from all around on a surface with that normal; 1 for a white surrounding.
vec3 environment_light(vec3 n) {
#ifdef ENVIRONMENT
  vec3 sum = 0.28209479 * frame.environment[0].rgb;
  sum += 0.48860251 * (n.y * frame.environment[1].rgb + n.z * frame.environment[2].rgb + n.x * frame.environment[3].rgb);
  sum += 1.09254843 * (n.x * n.y * frame.environment[4].rgb + n.y * n.z * frame.environment[5].rgb +
                       n.x * n.z * frame.environment[7].rgb);
  sum += 0.31539157 * (3.0 * n.z * n.z - 1.0) * frame.environment[6].rgb;
  sum += 0.54627422 * (n.x * n.x - n.y * n.y) * frame.environment[8].rgb;
  return max(sum, 0.0);
#else
  return vec3(1.0);
#endif
}

struct Fibre {
  vec3 place, normal, tangent, to_eye;
  vec3 colour;    // C
  float height;   // s in [0, 1]
  float depth;    // optical depth to a light along the normal
};

vec3 fibre_light(Fibre fibre) {
  float ground = mix(frame.weights.w, 1.0, fibre.height);
  vec3 ambient_kept = transmittance(0.6 * fibre.depth * frame.exponents.w, fibre.colour);
  vec3 sum = frame.weights.x * ground * fibre.colour * ambient_kept * environment_light(fibre.normal);
  for (int i = 0; i < int(frame.counts.z); ++i) {
    vec3 to_light, radiance;
    light_at(i, fibre.place, to_light, radiance);
    vec3 middle = to_light + fibre.to_eye;
    middle *= inversesqrt(max(dot(middle, middle), 1e-12));
    float along_light = dot(fibre.tangent, to_light), along_middle = dot(fibre.tangent, middle);
    float facing = dot(fibre.normal, to_light);
    float diffuse = power(max(0.0, 1.0 - along_light * along_light), 0.5 * frame.exponents.x);
    float specular = power(max(0.0, 1.0 - along_middle * along_middle), 0.5 * frame.exponents.y);
    float back = facing >= 0.0 ? 1.0 : 1.0 - min(-facing, frame.exponents.z) / frame.exponents.z;
    float depth = frame.exponents.w * fibre.depth / max(facing, 0.3);
#ifdef SHADOW_MAPS
    depth = layer_depth(i, fibre.place, fibre.height, facing, depth);
    radiance *= cast_light(i, fibre.place);
#endif
    vec3 kept = transmittance(depth, fibre.colour);
    vec3 scattered = frame.weights.y * fibre.colour * diffuse + frame.weights.z * specular;
    sum += radiance * scattered * kept * back;
  }
  return sum;
}
