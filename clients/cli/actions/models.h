// Loads a model file into a scene.
#pragma once

#include <string>

#include "clients/cli/session.h"

namespace pelage {

/// Sends the file that the options name to the scene at `scene_path`. If the server refuses the file, the error says
/// what to do next.
Result<HttpAnswer> load_into(Session& session, const std::string& scene_path);

}  // namespace pelage
