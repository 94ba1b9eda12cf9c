// Pictures that get better while the client waits.
#pragma once

#include <string>

#include "clients/cli/session.h"

namespace pelage {

/// Writes the rasterized picture of a request with `progressive`, then each better picture of the scene over the same
/// file, until the last one, `until_pass` or `for_seconds`. A line for each. `path` is the scene's.
ExitCode follow_progressive(Session& session, const std::string& path, const std::string& request);

}  // namespace pelage
