#include "renderer/strands/strand_shading.h"

#include <algorithm>

#include "renderer/coat/strand_tile.h"

namespace pelage {

namespace {

constexpr int wetness_steps = 8;

/// Beside the highlights of models without fibres, which painted water changes too.
Look traced_look(const FurFrame& frame) {
  Look look = frame.look;
  look.fibre = wet_look(frame.coat, look).fibre;
  const Tracing& trace = frame.knobs.trace;
  if (trace.transport == Transport::paths || trace.scattering == StrandScattering::energy_conserving)
    look.shading = ShadingModel::energy_conserving;
  return look;
}

bool has_shine(ShadingModel model) {
  return model != ShadingModel::energy_conserving && model != ShadingModel::marschner;
}

}  // namespace

StrandShading::StrandShading(const FurFrame& frame)
    : look_(traced_look(frame)),
      wetness_(frame.coat.wetness),
      lobes_(energy_conserving_lobes(look_.fibre)),
      table_(make_scattering_table(look_)) {
  const int steps = has_shine(look_.shading) ? wetness_steps : 0;
  for (int i = 0; i <= steps; ++i) {
    Coat coat;  // as paint_light.glsl has it
    coat.wetness = std::min(wetness_ + static_cast<double>(i) / wetness_steps, 1.0);
    Look wet = wet_look(coat, look_);
    wet.fibre = look_.fibre;
    shadings_.emplace_back(wet);
  }
}

bool StrandShading::fits(const FurFrame& frame) const {
  return look_ == traced_look(frame) && wetness_ == frame.coat.wetness;
}

glm::vec3 StrandShading::absorption(glm::vec3 colour) const {
  return glm::vec3(shadings_.front().absorption(glm::dvec3(glm::min(colour, 1.0f))));
}

glm::vec3 StrandShading::scatter(const Hit& hit, glm::vec3 to_light, glm::vec3 to_camera) const {
  const auto last = static_cast<float>(shadings_.size() - 1);
  const auto step = static_cast<std::size_t>(std::clamp(hit.wetness, 0.0f, 1.0f) * last + 0.5f);
  const ScatterGeometry geometry{hit.tangent, hit.normal, to_light, to_camera};
  return glm::vec3(shadings_[step].scatter(geometry, glm::dvec3(glm::min(hit.colour, 1.0f)), hit.number, table_));
}

glm::vec3 StrandShading::scatter_averaged(const Hit& hit, glm::vec3 sigma_a, glm::vec3 to_light,
                                          glm::vec3 to_camera) const {
  const ScatterGeometry geometry{hit.tangent, hit.normal, to_light, to_camera};
  return glm::vec3(shadings_.front().scatter_absorbed(geometry, glm::dvec3(sigma_a), table_));
}

}  // namespace pelage
