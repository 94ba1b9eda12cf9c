// Traces the full light transport of strands: light goes from strand to strand and to the skin, along whole paths
// (Kajiya 1986), scattered by energy_conserving at the offset where each strand was hit. Energy is conserved except for
// the bounds on bounces and on brightness.
#pragma once

#include "renderer/strands/transmitted_light.h"

namespace pelage {

/// What a ray through a place of the picture sees.
FilmSample path_sample(const TraceScene& scene, const World& world, glm::vec2 place, float time, Sampler& sampler);

}  // namespace pelage
