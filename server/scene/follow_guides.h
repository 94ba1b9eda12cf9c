// Guide curves of another program, for the fur to follow.
#pragma once

#include <vector>

#include "protocol/commands/creature.h"
#include "protocol/commands/guides.h"
#include "server/scene/scene.h"

namespace pelage {

/// Runs an `interpolate` with a key for each curve of a file, thinned to upload.keys and to what one command may
/// cost. Warns of curves that were left out. Refused as Scene::execute does, and (invalid) where no curve stands
/// on the skin.
Result<CommandAnswer> follow_guides(Scene& scene, const GuideUpload& upload, const std::vector<GuideCurve>& curves,
                                    const ExecuteOptions& options);

}  // namespace pelage
