// Traces the full light transport: whole paths (Kajiya 1986) from strand to strand and to the skin. Strands scatter by
// energy_conserving at the offset where they were hit. Energy is conserved except for the limits on bounces and on
// brightness.
#pragma once

#include "renderer/strands/transmitted_light.h"

namespace pelage {

/// Traces a camera ray through a pixel position and the path that follows.
FilmSample path_sample(const TraceScene& scene, const World& world, glm::vec2 position, float time, Sampler& sampler);

}  // namespace pelage
