// Every shading model (science.md 4), as renderer/shading has them in double; tests/gl compares both on a grid.
// The caller binds ScatteringBlock of renderer/shading/scattering_table.h and, for the two fibre models, the table of
// scattering_table.h as a 3D texture of RGBA32F, linear, clamped to its edges.
#include "constants.glsl"
layout(std140, binding = scattering_binding) uniform ScatteringBlock {
  ivec4 model;       // by number; 1 where the absorption is given
  vec4 weights;      // diffuse, specular, secondary specular, shift spread
  vec4 exponents;    // diffuse, specular, secondary; colour to absorption coordinate
  vec4 shifts;       // primary, secondary
  vec4 absorption;   // absorption coordinates where they are given
  vec4 tilt_sine;    // for each lobe: R, TT, TRT, the rest
  vec4 tilt_cosine;
  vec4 centre;       // theta_h of the peak
  vec4 over_variance;
  vec4 normaliser;
} scattering;

layout(binding = scattering_unit) uniform sampler3D azimuthal_table;  // azimuth coordinate, cos theta, absorption; R, TT, TRT, the rest

#ifdef PAINT
float shine = 1.0, sharpness = 1.0;  // factors on the highlight's weight and exponent that painted water sets
#else
const float shine = 1.0, sharpness = 1.0;
#endif

// (1 - d^2)^(n/2). Near d = 0 the series of the logarithm keeps the digits that 1 - d^2 loses.
float sine_power(float d, float n) {
  float x = d * d;
  if (x >= 1.0) return n > 0.0 ? 0.0 : 1.0;
  float series = -x * (1.0 + x * (0.5 + x * (0.33333333 + x * (0.25 + x * (0.2 + x * 0.16666667)))));
  return exp(0.5 * n * (x < 0.08 ? series : log(1.0 - x)));
}

float sine_to(float cosine) { return sqrt(max(0.0, 1.0 - cosine * cosine)); }

vec3 unit_or_zero(vec3 v) { return v * inversesqrt(max(dot(v, v), 1e-12)); }

vec3 scatter_kajiya(vec3 tangent, vec3 to_light, vec3 to_camera, vec3 colour) {
  float diffuse = sine_power(dot(tangent, to_light), scattering.exponents.x);
  float specular = sine_power(dot(tangent, unit_or_zero(to_light + to_camera)), sharpness * scattering.exponents.y);
  return scattering.weights.x * diffuse * colour + shine * scattering.weights.y * specular;
}

// The cosine to the mirror direction by its sine, which keeps its digits where the cosine is near 1.
vec3 scatter_kajiya_kay(vec3 tangent, vec3 to_light, vec3 to_camera, vec3 colour) {
  float along_light = dot(tangent, to_light), along_view = dot(tangent, to_camera);
  float sine_light = sine_to(along_light), sine_view = sine_to(along_view);
  float mirror = sine_light * sine_view - along_light * along_view;
  float off_mirror = sine_light * along_view + sine_view * along_light;
  float highlight = sine_power(mirror > 0.0 ? off_mirror : 1.0, sharpness * scattering.exponents.y);
  return scattering.weights.x * sine_light * colour + shine * scattering.weights.y * highlight;
}

float scheuermann_lobe(float along, float n) { return smoothstep(-1.0, 0.0, along) * sine_power(along, n); }

vec3 scatter_scheuermann(vec3 tangent, vec3 normal, vec3 to_light, vec3 to_camera, vec3 colour, float strand) {
  vec3 middle = unit_or_zero(to_light + to_camera);
  vec2 shift = scattering.shifts.xy + scattering.weights.w * (2.0 * strand - 1.0);
  float first = scheuermann_lobe(dot(unit_or_zero(tangent + shift.x * normal), middle), sharpness * scattering.exponents.y);
  float second = scheuermann_lobe(dot(unit_or_zero(tangent + shift.y * normal), middle), scattering.exponents.z);
  float wrapped = clamp(0.25 + 0.75 * dot(normal, to_light), 0.0, 1.0);
  return (scattering.weights.x * wrapped + scattering.weights.z * second) * colour + shine * scattering.weights.y * first;
}

// exp(-x) I0(x) for x >= 0, within 4e-4 of itself: its square's inverse is 1 + 2 x near 0 and 2 pi x far out, and a ratio of
// polynomials between (a least squares fit of ours). No branch and no exponential, unlike Abramowitz and Stegun 9.8.1.
vec4 scaled_bessel_i0(vec4 x) {
  vec4 over = 1.0 + x * (2.37362723 + x * (2.65343988 + x * (1.1803919 + x * 1.1000664)));
  vec4 under = 1.0 + x * (0.38860871 + x * (0.23850039 + x * 0.17503195));
  return inversesqrt(over / under);
}

// Mp of d'Eon 2011 for each lobe. Sines of the inclinations are about the axis from tip to root.
vec4 longitudinal_lobes(float sine_light, float sine_view) {
  float cosine_light = sine_to(sine_light), cosine_view = sine_to(sine_view);
  vec4 tilted_sine = sine_view * scattering.tilt_cosine + cosine_view * scattering.tilt_sine;
  vec4 tilted_cosine = abs(cosine_view * scattering.tilt_cosine - sine_view * scattering.tilt_sine);
  vec4 apart = cosine_light - tilted_cosine, sum = sine_light + tilted_sine;
  vec4 fall = exp(-0.5 * (apart * apart + sum * sum) * scattering.over_variance) * scattering.normaliser;
  return fall * scaled_bessel_i0(cosine_light * tilted_cosine * scattering.over_variance);
}

// M of Marschner 2003 over cos^2 theta_d for each lobe, and cos theta_d.
vec4 marschner_longitudinal(float sine_light, float sine_view, out float cos_difference) {
  float light = atan(sine_light, sine_to(sine_light)), view = atan(sine_view, sine_to(sine_view));
  vec4 apart = 0.5 * (light + view) - scattering.centre;
  cos_difference = cos(0.5 * (light - view));
  return exp(-0.5 * apart * apart * scattering.over_variance) * scattering.normaliser /
         max(cos_difference * cos_difference, 1e-3);
}

// |phi| between light and view around the strand as azimuth_coordinate of scattering_table.h has it, by the perimeter of a
// square: no arc tangent. Along the strand there is none: the middle of the range then.
float azimuth_between(vec3 tangent, vec3 to_light, vec3 to_camera) {
  vec3 view = to_camera - tangent * dot(tangent, to_camera), light = to_light - tangent * dot(tangent, to_light);
  float x = dot(view, light), y = abs(dot(tangent, cross(view, light)));
  float perimeter = abs(x) + y;
  return perimeter > 1e-10 ? 0.5 - 0.5 * x / perimeter : 0.5;
}

vec3 absorption_coordinates(vec3 colour) {
  if (scattering.model.y == 1) return scattering.absorption.rgb;
  return exp2(scattering.exponents.w * log2(clamp(colour, 1e-6, 1.0)));
}

// Average over the fibre's width of Ap Np, for each lobe. The first and last texels lie on the ends of each range.
vec4 azimuthal_lobes(float azimuth, float cos_theta, float absorption) {
  vec3 at = clamp(vec3(azimuth, cos_theta, absorption), 0.0, 1.0);
  vec3 size = vec3(textureSize(azimuthal_table, 0));
  return textureLod(azimuthal_table, (at * (size - 1.0) + 0.5) / size, 0.0);
}

vec3 scatter_fibre(int model, vec3 tangent, vec3 to_light, vec3 to_camera, vec3 colour) {
  float sine_light = clamp(-dot(tangent, to_light), -1.0, 1.0), sine_view = clamp(-dot(tangent, to_camera), -1.0, 1.0);
  float cos_theta = sine_to(sine_view), gain = 3.14159265;
  vec4 m;
  if (model == model_marschner) {
    m = marschner_longitudinal(sine_light, sine_view, cos_theta);
    gain *= sine_to(sine_light);
  } else {
    m = longitudinal_lobes(sine_light, sine_view);
  }
  float azimuth = azimuth_between(tangent, to_light, to_camera);
  vec3 at = absorption_coordinates(colour);
  return gain * vec3(dot(m, azimuthal_lobes(azimuth, cos_theta, at.r)),
                     dot(m, azimuthal_lobes(azimuth, cos_theta, at.g)),
                     dot(m, azimuthal_lobes(azimuth, cos_theta, at.b)));
}

// B of GPU fur eq 1: models that know about light from behind keep all of it.
float light_behind(int model, float facing, float reach) {
  bool surface = model == model_lengyel || model == model_kajiya || model == model_kajiya_kay;
  return surface && facing < 0.0 ? 1.0 - min(-facing, reach) / reach : 1.0;
}

// Light scattered to the camera for light of radiance 1, without shadow, B and ambient. Directions are unit and point away
// from the strand, the tangent from root to tip; colour in [0, 1]; strand is the strand's number in [0, 1].
vec3 scatter(int model, vec3 tangent, vec3 normal, vec3 to_light, vec3 to_camera, vec3 colour, float strand) {
  if (model == model_energy_conserving || model == model_marschner) {
    return scatter_fibre(model, tangent, to_light, to_camera, colour);
  }
  if (model == model_scheuermann) return scatter_scheuermann(tangent, normal, to_light, to_camera, colour, strand);
  if (model == model_kajiya_kay) return scatter_kajiya_kay(tangent, to_light, to_camera, colour);
  return scatter_kajiya(tangent, to_light, to_camera, colour);
}
