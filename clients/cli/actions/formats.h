// Chooses file formats by file extension.
#pragma once

#include <string>
#include <utility>
#include <vector>

#include "base/status.h"
#include "clients/cli/options.h"

namespace pelage {

/// Pairs of a file extension, such as ".png", and its format. The first pair has the extension "" and is used for
/// outputs without an extension, such as standard output.
using ExtensionFormats = std::vector<std::pair<std::string, const char*>>;

/// Returns the parameters with a `format` added according to the output's file extension, unless they have one already.
/// Fails (invalid) if the extension is not among `formats`.
Result<Parameters> with_format(Parameters parameters, const std::string& output, const ExtensionFormats& formats);

}  // namespace pelage
