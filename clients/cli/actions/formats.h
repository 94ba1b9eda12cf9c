// Formats that the endings of files stand for.
#pragma once

#include <string>
#include <utility>
#include <vector>

#include "base/status.h"
#include "clients/cli/options.h"

namespace pelage {

/// The formats that endings stand for; that of none, as of standard output, comes first.
using Endings = std::vector<std::pair<std::string, const char*>>;

/// The parameters with the format that the output's ending stands for, unless they name one. Refused (invalid) where
/// it stands for none.
Result<Parameters> with_format(Parameters parameters, const std::string& output, const Endings& endings);

}  // namespace pelage
