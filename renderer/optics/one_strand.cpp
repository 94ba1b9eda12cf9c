#include "renderer/optics/one_strand.h"

#include <cassert>

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "renderer/optics/one_strand.cpp"
#include <hwy/foreach_target.h>  // IWYU pragma: keep

#include "renderer/optics/scattering-inl.h"

HWY_BEFORE_NAMESPACE();
namespace pelage::HWY_NAMESPACE {

/// The same in all lanes.
HWY_INLINE Scattering lanes_of(const StrandOptics& optics, const LitStrand& strand) {
  return {Vec3(strand.tangent), Vec3(strand.normal), Vec3(strand.to_camera),
          Vec3(strand.colour),  strand.number,       shine_of(optics.wetness, strand.wetness)};
}

HWY_INLINE glm::vec3 first_lane(Vec3 v) { return {hn::GetLane(v.x.v), hn::GetLane(v.y.v), hn::GetLane(v.z.v)}; }

glm::vec3 ScatterStrand(const StrandOptics& optics, const LitStrand& strand) {
  const Scattering s = lanes_of(optics, strand);
  const Vec3 to_light(strand.to_light);
  FibreEye eye;
  if (scatters_fibres(optics.model)) eye = fibre_eye(optics.scattering, s);
  return first_lane(scatter(optics.scattering, optics.azimuthal, optics.model, s, eye, to_light) *
                    light_behind(optics.model, dot(s.normal, to_light), optics.reach));
}

glm::vec3 ScatterOnce(const StrandOptics& optics, const LitStrand& strand) {
  const Scattering s = lanes_of(optics, strand);
  return first_lane(scatter_fibre(optics.scattering, optics.azimuthal, s, fibre_eye(optics.scattering, s),
                                  Vec3(strand.to_light), optics.model == model_marschner));
}

glm::vec3 ScatterBundle(const StrandOptics& optics, const LitStrand& strand, glm::vec3 once) {
  return first_lane(scatter_bundle(optics.scattering, lanes_of(optics, strand), Vec3(strand.to_light), Vec3(once)));
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
