// `pelage compare`: measures the error of one picture against another.
#pragma once

#include "clients/cli/options.h"
#include "clients/cli/terminal/report.h"

namespace pelage {

/// Compares local picture files and prints the figures, or the reason why there are none. Needs no server.
ExitCode compare_pictures(const Options& options);

}  // namespace pelage
