// What `pelage compare` does.
#pragma once

#include "clients/cli/options.h"
#include "clients/cli/terminal/report.h"

namespace pelage {

/// Measures local files and prints the figures or why there are none; no server is asked.
ExitCode compare_pictures(const Options& options);

}  // namespace pelage
