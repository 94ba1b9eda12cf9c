// Every shading model (science.md 4) for several pixels at once: the twin of renderer/shaders/scattering.glsl, and of
// renderer/shading in double.
#if defined(PELAGE_OPTICS_SCATTERING_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef PELAGE_OPTICS_SCATTERING_INL_H_
#undef PELAGE_OPTICS_SCATTERING_INL_H_
#else
#define PELAGE_OPTICS_SCATTERING_INL_H_
#endif

#include "renderer/optics/azimuthal_fit.h"
#include "renderer/optics/lanes-inl.h"
#include "renderer/shaders/constants.h"
#include "renderer/shading/scattering_table.h"

HWY_BEFORE_NAMESPACE();
namespace pelage::HWY_NAMESPACE {

/// What painted water does to highlights: factors on their weight and exponent.
struct Shine {
  Real weight, exponent;
};

/// Of a coat of that wetness, for water that is painted beyond it: wet_shine and wet_sharpness over the coat's own.
HWY_INLINE Shine shine_of(float coat, Real painted) {
  const auto wetter = [=](double rise) HWY_ATTR {
    const auto by = static_cast<float>(rise);
    return (1.0f + by * min(coat + painted, 1.0f)) * (1 / (1 + by * coat));
  };
  return {wetter(water_shines), wetter(water_sharpens)};
}

/// A strand and who looks at it. Directions are unit and point away from the strand, the tangent from root to tip.
struct Scattering {
  Vec3 tangent, normal, to_camera;
  Vec3 colour;  // [0, 1]
  Real strand;  // its number, [0, 1]
  Shine shine;
};

/// (1 - d^2)^(n/2). Near d = 0 the series of the logarithm keeps the digits that 1 - d^2 loses.
HWY_INLINE Real sine_power(Real d, Real n) {
  const Real x = d * d;
  const Real series = -x * (1.0f + x * (0.5f + x * (0.33333333f + x * (0.25f + x * (0.2f + x * 0.16666667f)))));
  const Real rest = max(1.0f - x, 1e-12f);
  const Real power = exp(0.5f * n * select(x < 0.08f, series, log(rest)));
  return select(x >= 1.0f, select(n > 0.0f, 0.0f, 1.0f), power);
}

HWY_INLINE Real sine_to(Real cosine) { return sqrt(max(0.0f, 1.0f - cosine * cosine)); }

HWY_INLINE Vec3 unit_or_zero(Vec3 v) { return v * (1.0f / sqrt(max(dot(v, v), 1e-12f))); }

HWY_INLINE Vec3 scatter_kajiya(const ScatteringBlock& block, const Scattering& s, Vec3 to_light) {
  const Real diffuse = sine_power(dot(s.tangent, to_light), block.exponents.x);
  const Real specular =
      sine_power(dot(s.tangent, unit_or_zero(to_light + s.to_camera)), s.shine.exponent * block.exponents.y);
  return block.weights.x * diffuse * s.colour + Vec3(s.shine.weight * block.weights.y * specular);
}

/// The cosine to the mirror direction by its sine, which keeps its digits where the cosine is near 1.
HWY_INLINE Vec3 scatter_kajiya_kay(const ScatteringBlock& block, const Scattering& s, Vec3 to_light) {
  const Real along_light = dot(s.tangent, to_light), along_view = dot(s.tangent, s.to_camera);
  const Real sine_light = sine_to(along_light), sine_view = sine_to(along_view);
  const Real mirror = sine_light * sine_view - along_light * along_view;
  const Real off_mirror = sine_light * along_view + sine_view * along_light;
  const Real highlight = sine_power(select(mirror > 0.0f, off_mirror, 1.0f), s.shine.exponent * block.exponents.y);
  return block.weights.x * sine_light * s.colour + Vec3(s.shine.weight * block.weights.y * highlight);
}

HWY_INLINE Real scheuermann_lobe(Real along, Real n) { return smoothstep(-1.0f, 0.0f, along) * sine_power(along, n); }

HWY_INLINE Vec3 scatter_scheuermann(const ScatteringBlock& block, const Scattering& s, Vec3 to_light) {
  const Vec3 middle = unit_or_zero(to_light + s.to_camera);
  const Real spread = block.weights.w * (2.0f * s.strand - 1.0f);
  const Real first_shift = block.shifts.x + spread, second_shift = block.shifts.y + spread;
  const Real first = scheuermann_lobe(dot(unit_or_zero(s.tangent + first_shift * s.normal), middle),
                                      s.shine.exponent * block.exponents.y);
  const Real second =
      scheuermann_lobe(dot(unit_or_zero(s.tangent + second_shift * s.normal), middle), block.exponents.z);
  const Real wrapped = clamp(0.25f + 0.75f * dot(s.normal, to_light), 0.0f, 1.0f);
  return (block.weights.x * wrapped + block.weights.z * second) * s.colour +
         Vec3(s.shine.weight * block.weights.y * first);
}

/// Of R, TT, TRT and the rest.
struct Lobes {
  Real value[4];
};

/// exp(-x) I0(x) for x >= 0, as scattering.glsl has it.
HWY_INLINE Real bessel_without_growth(Real x) {
  const Real over = 1.0f + x * (2.37362723f + x * (2.65343988f + x * (1.1803919f + x * 1.1000664f)));
  const Real under = 1.0f + x * (0.38860871f + x * (0.23850039f + x * 0.17503195f));
  return sqrt(under / over);
}

/// What of a strand's view all lights share; the fibre models alone need it.
struct FibreEye {
  Real sine, cosine;  // of the inclination about the axis from tip to root
  Vec3 aside;         // to the camera, less what lies along the strand
  Vec3 absorption;    // coordinates of the three channels
};

/// Mp of d'Eon 2011 for each lobe.
HWY_INLINE Lobes longitudinal_lobes(const ScatteringBlock& block, Real sine_light, const FibreEye& eye) {
  const Real cosine_light = sine_to(sine_light);
  Lobes lobes;
  for (int p = 0; p < 4; ++p) {
    const Real tilted_sine = eye.sine * block.tilt_cosine[p] + eye.cosine * block.tilt_sine[p];
    const Real tilted_cosine = abs(eye.cosine * block.tilt_cosine[p] - eye.sine * block.tilt_sine[p]);
    const Real apart = cosine_light - tilted_cosine, sum = sine_light + tilted_sine;
    const Real fall = exp(-0.5f * (apart * apart + sum * sum) * block.over_variance[p]) * block.normaliser[p];
    lobes.value[p] = fall * bessel_without_growth(cosine_light * tilted_cosine * block.over_variance[p]);
  }
  return lobes;
}

/// Angle of a point at that sine and cosine >= 0, radians: by the half angle, whose tangent lies in [-1, 1].
HWY_INLINE Real inclination_of(Real sine) {
  const Real half = sine / (1.0f + sine_to(sine)), x2 = half * half;
  Real p = 0.0117212f;
  p = mul_add(p, x2, -0.05265332f);
  p = mul_add(p, x2, 0.11643287f);
  p = mul_add(p, x2, -0.19354346f);
  p = mul_add(p, x2, 0.33262347f);
  p = mul_add(p, x2, -0.99997726f);
  return -2.0f * half * p;
}

/// M of Marschner 2003 over cos^2 theta_d for each lobe, and cos theta_d.
HWY_INLINE Lobes marschner_longitudinal(const ScatteringBlock& block, Real sine_light, Real sine_view,
                                        Real& cos_difference) {
  const Real light = inclination_of(sine_light), view = inclination_of(sine_view);
  // cos((l - v) / 2), of which the square is (1 + cos(l - v)) / 2
  const Real cos_whole = sine_to(sine_light) * sine_to(sine_view) + sine_light * sine_view;
  cos_difference = sqrt(max(0.5f + 0.5f * cos_whole, 0.0f));
  const Real over_square = 1.0f / max(cos_difference * cos_difference, 1e-3f);
  Lobes lobes;
  for (int p = 0; p < 4; ++p) {
    const Real apart = 0.5f * (light + view) - block.centre[p];
    lobes.value[p] = exp(-0.5f * apart * apart * block.over_variance[p]) * block.normaliser[p] * over_square;
  }
  return lobes;
}

/// |phi| between light and view around the strand as azimuth_coordinate of scattering_table.h has it; along the strand
/// there is none: the middle of the range then.
HWY_INLINE Real azimuth_between(const Scattering& s, const FibreEye& eye, Vec3 to_light) {
  const Vec3 light = to_light - s.tangent * dot(s.tangent, to_light);
  const Real x = dot(eye.aside, light), y = abs(dot(s.tangent, cross(eye.aside, light))), perimeter = abs(x) + y;
  return select(perimeter > 1e-10f, 0.5f - 0.5f * x / max(perimeter, 1e-10f), 0.5f);
}

/// One axis of a table: the node below and the share of the next.
struct Node {
  Int first;
  Real share;
};
HWY_INLINE Node node_at(Real at, int nodes) {
  const Real place = clamp(at, 0.0f, 1.0f) * static_cast<float>(nodes - 1);
  const Real low = min(floor(place), static_cast<float>(nodes - 2));
  return {to_int(low), place - low};
}

HWY_INLINE Real lower_bfloat(Int word) { return hn::BitCast(float_tag, hn::ShiftLeft<16>(word)); }
HWY_INLINE Real upper_bfloat(Int word) {
  return hn::BitCast(float_tag, hn::And(word, whole(static_cast<std::int32_t>(0xffff0000))));
}

/// Average over the fibre's width of Ap Np weighed by `along`, as a polynomial in the absorption.
struct AbsorptionCurve {
  Real c0, c1, c2, c3;
  HWY_INLINE Real at(Real t) const { return mul_add(t, mul_add(t, mul_add(t, c3, c2), c1), c0); }
};

/// Adds the words of a node by their weight.
HWY_INLINE void add_node(const Int* word, Real weight, const Lobes& along, AbsorptionCurve& curve) {
  const Real tt = weight * along.value[1], trt = weight * along.value[2], rest = weight * along.value[3];
  curve.c0 = mul_add(weight * along.value[0], lower_bfloat(word[0]), curve.c0);
  curve.c1 += tt * upper_bfloat(word[0]) + trt * lower_bfloat(word[2]) + rest * upper_bfloat(word[3]);
  curve.c2 += tt * lower_bfloat(word[1]) + trt * upper_bfloat(word[2]) + rest * lower_bfloat(word[4]);
  curve.c3 += tt * upper_bfloat(word[1]) + trt * lower_bfloat(word[3]) + rest * upper_bfloat(word[4]);
}

HWY_INLINE AbsorptionCurve azimuthal_curve(const AzimuthalFit& fit, const Lobes& along, Node azimuth,
                                           Node inclination) {
  static_assert(2 * AzimuthalFit::words <= 3 * 4);
  const Real none = 0.0f;
  AbsorptionCurve curve{none, none, none, none};
  for (int row = 0; row < 2; ++row) {
    const Int j = hn::Add(inclination.first, whole(row));
    const Int node = hn::Mul(hn::Add(hn::Mul(j, whole(fit.azimuths)), azimuth.first), whole(AzimuthalFit::words));
    Int word[12];  // of two nodes side by side, and two more
    for (int quad = 0; quad < 3; ++quad) {
      const Quad found = gather_quad(fit.nodes.data() + 4 * quad, node);
      for (int k = 0; k < 4; ++k) word[4 * quad + k] = found.word[k];
    }
    const Real weight = row ? inclination.share : 1.0f - inclination.share;
    add_node(word, (1.0f - azimuth.share) * weight, along, curve);
    add_node(word + AzimuthalFit::words, azimuth.share * weight, along, curve);
  }
  return curve;
}

HWY_INLINE Vec3 absorption_coordinates(const ScatteringBlock& block, Vec3 colour) {
  if (block.model.y == 1) return Vec3(block.absorption);
  return each(colour, [&](Real c) HWY_ATTR { return exp2(block.exponents.w * log2(clamp(c, 1e-6f, 1.0f))); });
}

HWY_INLINE FibreEye fibre_eye(const ScatteringBlock& block, const Scattering& s) {
  const Real along = dot(s.tangent, s.to_camera), sine = clamp(-along, -1.0f, 1.0f);
  return {sine, sine_to(sine), s.to_camera - s.tangent * along, absorption_coordinates(block, s.colour)};
}

HWY_INLINE Vec3 scatter_fibre(const ScatteringBlock& block, const AzimuthalFit& fit, const Scattering& s,
                              const FibreEye& eye, Vec3 to_light, bool marschner) {
  const Real sine_light = clamp(-dot(s.tangent, to_light), -1.0f, 1.0f);
  Real cos_theta = eye.cosine, gain = 3.14159265f;
  Lobes along;
  if (marschner) {
    along = marschner_longitudinal(block, sine_light, eye.sine, cos_theta);
    gain *= sine_to(sine_light);
  } else {
    along = longitudinal_lobes(block, sine_light, eye);
  }
  const AbsorptionCurve curve = azimuthal_curve(fit, along, node_at(azimuth_between(s, eye, to_light), fit.azimuths),
                                                node_at(cos_theta, fit.inclinations));
  return each(eye.absorption, [&](Real t) HWY_ATTR { return gain * max(curve.at(t), 0.0f); });
}

/// B of GPU fur eq 1: models that know about light from behind keep all of it.
HWY_INLINE Real light_behind(int model, Real facing, float reach) {
  const bool surface = model == model_lengyel || model == model_kajiya || model == model_kajiya_kay;
  if (!surface) return 1.0f;
  return select(facing < 0.0f, 1.0f - min(-facing, reach) / max(reach, 1e-20f), 1.0f);
}

/// What a bundle sends back after many fibres: scatter_again of lighting.glsl.
HWY_INLINE Vec3 scatter_again(const ScatteringBlock& block, const Scattering& s, Vec3 to_light) {
  const Real along = dot(s.tangent, to_light);
  return 0.55f * block.weights.x * sqrt(max(0.0f, 1.0f - along * along)) * s.colour;
}

/// `once` and what follows it.
HWY_INLINE Vec3 scatter_bundle(const ScatteringBlock& block, const Scattering& s, Vec3 to_light, Vec3 once) {
  return 0.6f * once + scatter_again(block, s, to_light);
}

HWY_INLINE bool scatters_fibres(int model) { return model == model_energy_conserving || model == model_marschner; }

/// Light scattered to the camera for light of radiance 1, without shadow, B and ambient. `eye` is read by fibre models.
HWY_INLINE Vec3 scatter(const ScatteringBlock& block, const AzimuthalFit& fit, int model, const Scattering& s,
                        const FibreEye& eye, Vec3 to_light) {
  switch (model) {
    case model_energy_conserving:
    case model_marschner:
      return scatter_bundle(block, s, to_light, scatter_fibre(block, fit, s, eye, to_light, model == model_marschner));
    case model_scheuermann: return scatter_scheuermann(block, s, to_light);
    case model_kajiya_kay: return scatter_kajiya_kay(block, s, to_light);
    default: return scatter_kajiya(block, s, to_light);
  }
}

}  // namespace pelage::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
