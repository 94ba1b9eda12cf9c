#include "renderer/optics/one_strand.h"

#include <cassert>

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "renderer/optics/one_strand.cpp"
#include <hwy/foreach_target.h>  // IWYU pragma: keep

#include "renderer/optics/scattering-inl.h"

HWY_BEFORE_NAMESPACE();
namespace pelage::HWY_NAMESPACE {

/// Returns the strand in all lanes.
HWY_INLINE Fibre lanes_of(const StrandOptics& optics, const LitStrand& strand) {
  Fibre fibre{};
  fibre.tangent = Vec3(strand.tangent), fibre.normal = Vec3(strand.normal), fibre.to_camera = Vec3(strand.to_camera);
  fibre.colour = Vec3(strand.colour), fibre.number = strand.number;
  fibre.shine = shine_of(optics.wetness, strand.wetness);
  return fibre;
}

HWY_INLINE glm::vec3 first_lane(Vec3 v) { return {hn::GetLane(v.x.v), hn::GetLane(v.y.v), hn::GetLane(v.z.v)}; }

glm::vec3 ScatterStrand(const StrandOptics& optics, const LitStrand& strand) {
  const Fibre fibre = lanes_of(optics, strand);
  const Vec3 to_light(strand.to_light);
  FibreScattering by{optics.scattering, optics.azimuthal};
  FibreViewTerms view_terms;
  if (scatters_fibres(optics.model)) view_terms = by.fibre_view_terms(fibre);
  return first_lane(by.scatter(optics.model, fibre, view_terms, to_light) *
                    backlight_fade(optics.model, dot(fibre.normal, to_light), optics.reach));
}

glm::vec3 ScatterOnce(const StrandOptics& optics, const LitStrand& strand) {
  const Fibre fibre = lanes_of(optics, strand);
  FibreScattering by{optics.scattering, optics.azimuthal};
  return first_lane(
      by.scatter_fibre(fibre, by.fibre_view_terms(fibre), Vec3(strand.to_light), optics.model == model_marschner));
}

glm::vec3 ScatterBundle(const StrandOptics& optics, const LitStrand& strand, glm::vec3 once) {
  FibreScattering by{optics.scattering, optics.azimuthal};
  return first_lane(by.scatter_bundle(lanes_of(optics, strand), Vec3(strand.to_light), Vec3(once)));
}

}  // namespace pelage::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace pelage {

HWY_EXPORT(ScatterStrand);
HWY_EXPORT(ScatterOnce);
HWY_EXPORT(ScatterBundle);

glm::vec3 scatter_strand(const StrandOptics& optics, const LitStrand& strand) {
  return HWY_DYNAMIC_DISPATCH(ScatterStrand)(optics, strand);
}

glm::vec3 scatter_once(const StrandOptics& optics, const LitStrand& strand) {
  assert(optics.azimuthal.azimuths > 0);
  return HWY_DYNAMIC_DISPATCH(ScatterOnce)(optics, strand);
}

glm::vec3 scatter_bundle(const StrandOptics& optics, const LitStrand& strand, glm::vec3 once) {
  return HWY_DYNAMIC_DISPATCH(ScatterBundle)(optics, strand, once);
}

}  // namespace pelage
#endif
