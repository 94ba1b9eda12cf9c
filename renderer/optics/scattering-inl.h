// All shading models for several pixels at once: compiles renderer/shaders/shared, which is also GLSL, for SIMD lanes.
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

#define FUNCTION HWY_INLINE
#include "renderer/shaders/shared/strand.glsl"
#undef FUNCTION

/// Returns the factors for water painted beyond a coat's own wetness: wet_shine and wet_sharpness relative to the
/// coat's own.
HWY_INLINE Shine shine_of(float coat, Real painted) {
  const auto wetter = [=](double rise) HWY_ATTR {
    const auto by = static_cast<float>(rise);
    return (1.0f + by * min(coat + painted, 1.0f)) * (1 / (1 + by * coat));
  };
  return {wetter(water_shines), wetter(water_sharpens)};
}

/// A position on one axis of a table: the node below it and the weight of the next.
struct Node {
  Int first;
  Real share;
};
HWY_INLINE Node node_at(Real at, int nodes) {
  const Real coordinate = clamp(at, 0.0f, 1.0f) * static_cast<float>(nodes - 1);
  const Real low = min(floor(coordinate), static_cast<float>(nodes - 2));
  return {to_int(low), coordinate - low};
}

HWY_INLINE Real lower_bfloat(Int word) { return hn::BitCast(float_tag, hn::ShiftLeft<16>(word)); }
HWY_INLINE Real upper_bfloat(Int word) {
  return hn::BitCast(float_tag, hn::And(word, splat(static_cast<std::int32_t>(0xffff0000))));
}

/// Average of Ap Np over the fibre's width, weighted by `along`, as a polynomial in the absorption.
struct AbsorptionCurve {
  Real c0, c1, c2, c3;
  HWY_INLINE Real at(Real t) const { return mul_add(t, mul_add(t, mul_add(t, c3, c2), c1), c0); }
};

/// Adds a node's polynomials with a weight.
HWY_INLINE void add_node(const Int* word, Real weight, const Vec4& along, AbsorptionCurve& curve) {
  const Real tt = weight * along.y, trt = weight * along.z, residual = weight * along.w;
  curve.c0 = mul_add(weight * along.x, lower_bfloat(word[0]), curve.c0);
  curve.c1 += tt * upper_bfloat(word[0]) + trt * lower_bfloat(word[2]) + residual * upper_bfloat(word[3]);
  curve.c2 += tt * lower_bfloat(word[1]) + trt * upper_bfloat(word[2]) + residual * lower_bfloat(word[4]);
  curve.c3 += tt * upper_bfloat(word[1]) + trt * lower_bfloat(word[3]) + residual * upper_bfloat(word[4]);
}

HWY_INLINE AbsorptionCurve azimuthal_curve(const AzimuthalFit& fit, const Vec4& along, Node azimuth, Node inclination) {
  static_assert(2 * AzimuthalFit::words <= 3 * 4);
  const Real none = 0.0f;
  AbsorptionCurve curve{none, none, none, none};
  for (int row = 0; row < 2; ++row) {
    const Int j = hn::Add(inclination.first, splat(row));
    const Int node = hn::Mul(hn::Add(hn::Mul(j, splat(fit.azimuths)), azimuth.first), splat(AzimuthalFit::words));
    Int word[12];  // the words of two adjacent nodes, and two more
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

/// The blocks of a look, as FrameLight has those of a frame.
struct FibreScattering {
  const ScatteringBlock& scattering;
  const AzimuthalFit& azimuthal;

  HWY_INLINE Vec3 azimuthal_light(const Vec4& along, Real azimuth, Real cos_theta, Vec3 absorption) const {
    const AbsorptionCurve curve = azimuthal_curve(azimuthal, along, node_at(azimuth, azimuthal.azimuths),
                                                  node_at(cos_theta, azimuthal.inclinations));
    return max(Vec3(curve.at(absorption.x), curve.at(absorption.y), curve.at(absorption.z)), 0.0f);
  }

#define FUNCTION HWY_INLINE
#include "renderer/shaders/shared/scattering.glsl"
#undef FUNCTION
};

}  // namespace pelage::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
