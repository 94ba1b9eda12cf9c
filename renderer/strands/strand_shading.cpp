#include "renderer/strands/strand_shading.h"

#include "renderer/coat/strand_tile.h"

namespace pelage {

namespace {

Look traced_look(const FurFrame& frame) {
  Look look = wet_look(frame.wetness(), frame.look);
  const Tracing& trace = frame.knobs.trace;
  if (trace.transport == Transport::paths || trace.scattering == StrandScattering::energy_conserving)
    look.shading = ShadingModel::energy_conserving;
  return look;
}

StrandOptics optics_of(const Look& look, double wetness) {
  return {.scattering = scattering_block(look),
          .azimuthal = fit_azimuthal(make_scattering_table(look)),
          .model = static_cast<int>(look.shading),
          .reach = static_cast<float>(look.back_attenuation),
          .wetness = static_cast<float>(wetness)};
}

LitStrand lit(const Hit& hit, glm::vec3 to_light, glm::vec3 to_camera) {
  return {hit.tangent, hit.normal, to_camera, to_light, glm::min(hit.colour, 1.0f), hit.number, hit.wetness};
}

}  // namespace

StrandShading::StrandShading(const FurFrame& frame)
    : look_(traced_look(frame)),
      wetness_(frame.wetness()),
      lobes_(energy_conserving_lobes(look_.fibre)),
      optics_(optics_of(look_, wetness_)) {}

bool StrandShading::fits(const FurFrame& frame) const {
  return look_ == traced_look(frame) && wetness_ == frame.wetness();
}

glm::vec3 StrandShading::absorption(glm::vec3 colour) const {
  const FibreOptics& fibre = look_.fibre;
  if (fibre.absorption == Absorption::melanin)
    return glm::vec3(absorption_from_melanin(fibre.eumelanin, fibre.pheomelanin));
  return glm::vec3(absorption_from_colour(glm::dvec3(glm::min(colour, 1.0f)), fibre.azimuthal_roughness));
}

glm::vec3 StrandShading::scatter(const Hit& hit, glm::vec3 to_light, glm::vec3 to_camera) const {
  return scatter_strand(optics_, lit(hit, to_light, to_camera));
}

glm::vec3 StrandShading::scatter_once(const Hit& hit, glm::vec3 to_light, glm::vec3 to_camera) const {
  return pelage::scatter_once(optics_, lit(hit, to_light, to_camera));
}

glm::vec3 StrandShading::scatter_bundle(const Hit& hit, glm::vec3 to_light, glm::vec3 to_camera, glm::vec3 once) const {
  return pelage::scatter_bundle(optics_, lit(hit, to_light, to_camera), once);
}

}  // namespace pelage
