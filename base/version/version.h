// Which Pelage this is.
#pragma once

#include <string>

namespace pelage {

/// Returns the version of the project, such as "0.1.0".
const char* version();

/// "PROGRAM 0.1.0 (commit 3b078d3b1c0e, contract 1.0.0)"; the commit is "unknown" where no repository was built.
std::string version_line(const char* program);

}  // namespace pelage
