// The true way to light traced strands: light goes from strand to strand and to the skin, along whole paths (Kajiya
// 1986), scattered by energy_conserving at the offset where each strand was hit. Nothing is made or lost but at the
// bound of bounces and of brightness.
#pragma once

#include "renderer/strands/transmitted_light.h"

namespace pelage {

/// What a ray through a place of the picture sees.
FilmSample path_sample(const TraceScene& scene, const World& world, glm::vec2 place, float time, Sampler& sampler);

}  // namespace pelage
