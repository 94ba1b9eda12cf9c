// The version of this build.
#pragma once

#include <string>

namespace pelage {

/// Returns the version of the project, such as "0.1.0".
const char* version();

/// Returns "PROGRAM 0.1.0 (commit 3b078d3b1c0e, contract 1.0.0)"; the commit is "unknown" if the build had no Git
/// repository.
std::string version_line(const char* program);

}  // namespace pelage
