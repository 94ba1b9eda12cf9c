// A scene's model from a file.
#pragma once

#include <string>

#include "clients/cli/session.h"

namespace pelage {

/// Sends the options' file to the scene at `scene_path`. A refusal of the file says what to do next.
Result<HttpAnswer> load_into(Session& session, const std::string& scene_path);

}  // namespace pelage
