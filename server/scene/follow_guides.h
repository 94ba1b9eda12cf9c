// Grooms fur along guide curves that another program exported.
#pragma once

#include "protocol/commands/guides.h"
#include "server/scene/scene.h"

namespace pelage {

/// Runs an `interpolate` command with a key for each curve of a file. The curves are rotated and scaled to the scene as
/// the upload says, and thinned to upload.keys and to the cost limit of one command. The answer warns of curves that
/// were left out. Fails as Scene::execute does, and refuses (invalid) a file none of whose curves is rooted near the
/// skin.
Result<CommandAnswer> follow_guides(Scene& scene, const GuideUpload& upload, const GuideFile& file,
                                    const ExecuteOptions& options);

}  // namespace pelage
