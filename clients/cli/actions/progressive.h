// Progressive rendering from the command line.
#pragma once

#include <string>

#include "clients/cli/session.h"

namespace pelage {

/// Writes the rasterized picture of a request that has `progressive`, then overwrites the file with each better
/// picture, until the last one, --until-pass or --for. Prints a line for each picture. `path` is the scene's URL path.
ExitCode follow_progressive(Session& session, const std::string& path, const std::string& request);

}  // namespace pelage
