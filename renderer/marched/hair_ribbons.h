// Guard hairs among marched fur: the twin of renderer/passes/guard_hairs/hair.vert.
#pragma once

#include <span>
#include <vector>

#include "renderer/curves/guard_hairs.h"
#include "renderer/marched/march_scene.h"

namespace pelage {

/// The ribbons of hairs, one after the other, whose `hair` is the number among `roots`; near silhouettes alone. Their
/// colour is that of the coat's strands where they grow.
std::vector<Ribbon> hair_ribbons(const Coat& coat, std::span<const HairRoot> roots, const MarchScene& scene,
                                 const RibbonCamera& camera);

}  // namespace pelage
