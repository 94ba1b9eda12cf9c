// Guide curves of another program, for the fur to follow.
#pragma once

#include "protocol/commands/guides.h"
#include "server/scene/scene.h"

namespace pelage {

/// Runs an `interpolate` with a key for each curve of a file, turned and scaled to the scene as the upload says,
/// thinned to upload.keys and to what one command may cost. Warns of curves that were left out. Refused as
/// Scene::execute does, and (invalid) where no curve stands on the skin.
Result<CommandAnswer> follow_guides(Scene& scene, const GuideUpload& upload, const GuideFile& file,
                                    const ExecuteOptions& options);

}  // namespace pelage
