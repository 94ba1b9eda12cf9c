// Guide curves of another program, for the fur to follow.
#pragma once

#include <string_view>

#include "protocol/commands/guides.h"
#include "server/scene/scene.h"

namespace pelage {

/// Runs an `interpolate` with a key for each curve of the file, thinned to upload.keys and to what one command may
/// cost. Warns of curves that were left out. Refused as read_guides and Scene::execute do, and (invalid) where no curve
/// stands on the skin.
Result<CommandAnswer> load_guides(Scene& scene, const GuideUpload& upload, std::string_view bytes,
                                  const ExecuteOptions& options);

}  // namespace pelage
